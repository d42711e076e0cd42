// SPDX-License-Identifier: BSD-3-Clause
#include "StringArrays.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

namespace marrow
{
void SetStrings(vtkFieldData* data, const char* name, const std::vector<std::string>& strings)
{
  data->RemoveArray(name);
  if (strings.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& string : strings)
  {
    array->InsertNextValue(string);
  }
  data->AddArray(array);
}

std::vector<std::string> GetStrings(vtkFieldData* data, const char* name)
{
  std::vector<std::string> strings;
  auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    strings.push_back(array->GetValue(i));
  }
  return strings;
}
}
