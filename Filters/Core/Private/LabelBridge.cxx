// SPDX-License-Identifier: BSD-3-Clause
#include "LabelBridge.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkSetGet.h>
#include <vtkVariant.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace marrow
{
namespace
{
constexpr int Least = std::numeric_limits<int>::min();
constexpr int Most = std::numeric_limits<int>::max();

template <typename Value>
bool IsInRange(Value value)
{
  if constexpr (std::is_floating_point_v<Value>)
  {
    return static_cast<double>(value) >= Least && static_cast<double>(value) <= Most;
  }
  else if constexpr (std::is_signed_v<Value>)
  {
    return static_cast<long long>(value) >= Least && static_cast<long long>(value) <= Most;
  }
  else
  {
    return static_cast<unsigned long long>(value) <= static_cast<unsigned long long>(Most);
  }
}

/// The index of the first value that is no label, or -1.
template <typename Value>
vtkIdType Copy(const Value* values, vtkIdType size, std::vector<int>& labels)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (!IsInRange(values[i]))
    {
      return i;
    }
    labels[i] = static_cast<int>(values[i]);
    if (static_cast<Value>(labels[i]) != values[i])
    {
      return i;
    }
  }
  return -1;
}
}

std::string ToLabels(
  vtkDataArray* array, vtkIdType size, const char* where, std::vector<int>& labels)
{
  const std::string name =
    std::string("the array \"") + (array->GetName() ? array->GetName() : "") + "\" of segments ";
  if (array->GetNumberOfTuples() != size || array->GetNumberOfComponents() != 1)
  {
    return name + "has " + std::to_string(array->GetNumberOfTuples()) + " tuples of " +
      std::to_string(array->GetNumberOfComponents()) + " components but the mesh has " +
      std::to_string(size) + " " + where + "s: give one integer per " + where + ".";
  }
  labels.resize(size);
  vtkIdType bad = -1;
  switch (array->GetDataType())
  {
    vtkTemplateMacro(bad = Copy(static_cast<VTK_TT*>(array->GetVoidPointer(0)), size, labels));
    default:
      return name + "is of a type that has no integers: give one integer per " + where + ".";
  }
  if (bad < 0)
  {
    return {};
  }
  const std::string at = std::string(" at ") + where + " " + std::to_string(bad);
  const std::string value = array->GetVariantValue(bad).ToString();
  const double number = array->GetTuple1(bad);
  if (!std::isfinite(number) || number != std::floor(number))
  {
    return name + "is no integer" + at + " but " + value + ": give one integer per " + where + ".";
  }
  return name + "is " + value + at + ", beyond the range from " + std::to_string(Least) + " to " +
    std::to_string(Most) + ": number the segments anew.";
}

std::string ReadLabels(
  vtkPolyData* mesh, vtkDataArray* array, const std::string& name, std::vector<int>& labels)
{
  if (array)
  {
    return ToLabels(array, mesh->GetNumberOfCells(), "cell", labels);
  }
  std::string known;
  vtkCellData* cells = mesh->GetCellData();
  for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
  {
    const char* other = cells->GetArrayName(i);
    known += (known.empty() ? "" : ", ") + std::string("\"") + (other ? other : "") + "\"";
  }
  return "the mesh has no cell array \"" + name + "\" of segments; " +
    (known.empty()
        ? "it has no cell arrays: read a .seg file with vtkMarrowSegmentReader, or choose "
          "other labels with vtkMarrowSegmentSelector."
        : "it has " + known +
          ": choose one with SetInputArrayToProcess or vtkMarrowSegmentSelector.");
}
}
