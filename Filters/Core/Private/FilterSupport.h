// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FilterSupport_h
#define marrow_FilterSupport_h

#include "Progress.h"

#include <string>

class vtkAlgorithm;
class vtkDataSet;
class vtkInformationVector;

/// What every filter of ours needs of VTK.
namespace marrow
{
/// Whether the user asked the filter to stop. Call from one thread only.
bool IsAborted(vtkAlgorithm* filter);

/// Whether this process has no part in the work: several share it (ParaView's servers under mpiexec),
/// and the whole of `input` is with the first. Its output is then to stay empty, and is no error.
bool IsIdleProcess(vtkInformationVector* output, vtkDataSet* input);

/// The name of the array of segments that the filter is to take: as was set for its first array, or SegmentId.
std::string NameOfSegments(vtkAlgorithm* filter);

/// A callback that moves the filter's progress from `from` to `to`, in steps of a thousandth or more,
/// and tells of an abort.
Progress ProgressOf(vtkAlgorithm* filter, double from = 0.0, double to = 1.0);
}

#endif
