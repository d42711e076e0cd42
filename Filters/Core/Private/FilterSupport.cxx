// SPDX-License-Identifier: BSD-3-Clause
#include "FilterSupport.h"

#include "ArrayNames.h"
#include "VTKVersions.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace marrow
{
bool IsAborted(vtkAlgorithm* filter)
{
  return versions::CheckAbort(filter);
}

bool IsIdleProcess(vtkInformationVector* output, vtkDataSet* input)
{
  vtkInformation* info = output->GetInformationObject(0);
  return vtkStreamingDemandDrivenPipeline::GetUpdatePiece(info) > 0 &&
    input->GetNumberOfPoints() == 0;
}

std::string NameOfSegments(vtkAlgorithm* filter)
{
  const char* given = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  return given ? given : names::SegmentId;
}

Progress ProgressOf(vtkAlgorithm* filter, double from, double to)
{
  // Throttled, as observers can be slow and nobody sees smaller steps.
  constexpr double leastStep = 0.001;
  return [filter, from, to, told = -1.0](double fraction) mutable
  {
    const double done = from + (to - from) * fraction;
    if (done >= told + leastStep || fraction >= 1.0)
    {
      told = done;
      filter->UpdateProgress(done);
    }
    return !IsAborted(filter);
  };
}
}
