// SPDX-License-Identifier: BSD-3-Clause
#include "HintBridge.h"

#include "ArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

namespace marrow
{
std::string ReadHints(vtkPointSet* source, vtkPointSet* target, std::vector<PointHint>& hints)
{
  const vtkIdType size = source ? source->GetNumberOfPoints() : 0;
  const vtkIdType targetSize = target ? target->GetNumberOfPoints() : 0;
  hints.clear();
  if (size != targetSize)
  {
    return "Hints: there are " + std::to_string(size) + " points on the source and " +
      std::to_string(targetSize) + " on the target: give as many on the one as on the other.";
  }
  vtkDataArray* forbidden = size > 0 ? source->GetPointData()->GetArray(names::Forbidden) : nullptr;
  for (vtkIdType i = 0; i < size; ++i)
  {
    PointHint hint;
    source->GetPoint(i, hint.Source.data());
    target->GetPoint(i, hint.Target.data());
    if (!hint.Source.allFinite() || !hint.Target.allFinite())
    {
      return "Hints: point " + std::to_string(i) + " is not finite: remove it.";
    }
    hint.IsForbidden = forbidden && forbidden->GetComponent(i, 0) != 0.0;
    hints.push_back(hint);
  }
  return {};
}
}
