// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelFor.h"

#include <vtkSMPTools.h>

namespace marrow
{
void ParallelFor(int begin, int end, const std::function<void(int, int)>& body)
{
  vtkSMPTools::For(begin, end,
    [&body](vtkIdType first, vtkIdType last)
    { body(static_cast<int>(first), static_cast<int>(last)); });
}
}
