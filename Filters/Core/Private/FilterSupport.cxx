// SPDX-License-Identifier: BSD-3-Clause
#include "FilterSupport.h"

#include <vtkAlgorithm.h>
#include <vtkVersionMacros.h>

namespace marrow
{
bool IsAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220823)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

Progress ProgressOf(vtkAlgorithm* filter, double from, double to)
{
  return [filter, from, to](double fraction)
  {
    filter->UpdateProgress(from + (to - from) * fraction);
    return !IsAborted(filter);
  };
}
}
