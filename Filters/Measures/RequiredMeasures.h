// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_RequiredMeasures_h
#define marrow_RequiredMeasures_h

#include <string>

class vtkAlgorithm;
class vtkPolyData;

/// For the filters that make a skeleton: not installed, as it speaks Core's private words.
namespace marrow
{
struct SkeletonMeasures;

/// Reads the arrays AGD, MSP, MSPCenter and MSPValid of `mesh`. Where one of them is missing,
/// vtkMSPField is run with its defaults inside of `outer`, whose progress goes from `from` to `to`,
/// and its arrays are added to `mesh`. Returns one sentence that says what is wrong, or an empty
/// one; after an abort, which only IsAborted(outer) tells, `measures` are not filled.
std::string RequireMeasures(
  vtkAlgorithm* outer, double from, double to, vtkPolyData* mesh, SkeletonMeasures& measures);
}

#endif
