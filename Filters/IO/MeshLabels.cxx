// SPDX-License-Identifier: BSD-3-Clause
#include "MeshLabels.h"

#include "ArrayNames.h"
#include "FileMesh.h"
#include "LabelBridge.h"
#include "PartNumbers.h"
#include "StringArrays.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <map>
#include <set>

namespace marrow
{
namespace
{
constexpr const char* Colors = "colors";

struct Parts
{
  const char* Labels; ///< what the user calls them
  const char* Ids;
  const char* Names;
};
constexpr Parts AllParts[] = { { "groups", names::GroupId, names::GroupName },
  { "objects", names::ObjectId, names::ObjectName },
  { "materials", names::MaterialId, names::MaterialName } };

vtkUnsignedCharArray* ColorsOf(vtkDataSetAttributes* data)
{
  for (vtkDataArray* array : { data->GetArray(ColorsName), data->GetScalars() })
  {
    auto* colors = vtkUnsignedCharArray::SafeDownCast(array);
    if (colors && (colors->GetNumberOfComponents() == 3 || colors->GetNumberOfComponents() == 4))
    {
      return colors;
    }
  }
  return nullptr;
}

/// What can be chosen, for messages.
std::string Choices(vtkPolyData* mesh)
{
  std::string list;
  const auto add = [&list](const std::string& name)
  { list += (list.empty() ? "\"" : ", \"") + name + "\""; };
  std::set<std::string> hidden;
  for (const Parts& parts : AllParts)
  {
    if (mesh->GetCellData()->HasArray(parts.Ids))
    {
      add(parts.Labels);
      hidden.insert(parts.Ids);
    }
  }
  if (ColorsOf(mesh->GetCellData()) || ColorsOf(mesh->GetPointData()))
  {
    add(Colors);
  }
  const std::pair<vtkDataSetAttributes*, vtkIdType> both[] = { { mesh->GetCellData(),
                                                                 mesh->GetNumberOfCells() },
    { mesh->GetPointData(), mesh->GetNumberOfPoints() } };
  for (const auto& [data, size] : both)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      std::vector<int> labels;
      if (array && array->GetName() && hidden.insert(array->GetName()).second &&
        ToLabels(array, size, "cell", labels).empty())
      {
        add(array->GetName());
      }
    }
  }
  return list;
}

/// From labels of points to labels of cells.
std::string LabelsOfCorners(
  vtkPolyData* mesh, const std::vector<int>& labelOfPoint, std::vector<int>& labels)
{
  labels.resize(mesh->GetNumberOfCells());
  vtkNew<vtkIdList> points;
  std::vector<int> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, points);
    if (points->GetNumberOfIds() == 0)
    {
      return "Cell " + std::to_string(cell) +
        " has no corners, and so no label from those of the points: choose labels of cells.";
    }
    corners.clear();
    for (const vtkIdType point : *points)
    {
      corners.push_back(labelOfPoint[point]);
    }
    labels[cell] = MostFrequent(corners);
  }
  return {};
}

/// Numbers an array of colours.
void LabelsOfColors(
  vtkUnsignedCharArray* array, std::vector<int>& labels, std::vector<std::string>& nameOfId)
{
  std::map<FileColor, int> indices;
  std::vector<FileColor> colors;
  labels.clear();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    FileColor color{ 0, 0, 0, 255 };
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      color[k] = array->GetTypedComponent(i, k);
    }
    const auto [found, isNew] = indices.emplace(color, static_cast<int>(colors.size()));
    if (isNew)
    {
      colors.push_back(color);
    }
    labels.push_back(found->second);
  }
  const NumberedParts numbered = NumberColors(colors);
  for (int& label : labels)
  {
    label = numbered.IdOfPart[label];
  }
  nameOfId = numbered.NameOfId;
}

std::string LabelsOfColors(vtkPolyData* mesh, MeshLabels& labels)
{
  if (vtkUnsignedCharArray* colors = ColorsOf(mesh->GetCellData()))
  {
    LabelsOfColors(colors, labels.Ids, labels.NameOfId);
    return {};
  }
  std::vector<int> labelOfPoint;
  LabelsOfColors(ColorsOf(mesh->GetPointData()), labelOfPoint, labels.NameOfId);
  return LabelsOfCorners(mesh, labelOfPoint, labels.Ids);
}
}

std::string SelectLabels(vtkPolyData* mesh, const std::string& name, MeshLabels& labels)
{
  labels = MeshLabels();
  if (vtkDataArray* array = mesh->GetCellData()->GetArray(name.c_str()))
  {
    if (name == names::SegmentId)
    {
      labels.NameOfId = GetStrings(mesh->GetFieldData(), names::SegmentName);
    }
    return ToLabels(array, mesh->GetNumberOfCells(), "cell", labels.Ids);
  }
  if (vtkDataArray* array = mesh->GetPointData()->GetArray(name.c_str()))
  {
    std::vector<int> labelOfPoint;
    const std::string error = ToLabels(array, mesh->GetNumberOfPoints(), "point", labelOfPoint);
    return error.empty() ? LabelsOfCorners(mesh, labelOfPoint, labels.Ids) : error;
  }
  for (const Parts& parts : AllParts)
  {
    vtkDataArray* array = mesh->GetCellData()->GetArray(parts.Ids);
    if (name == parts.Labels && array)
    {
      labels.NameOfId = GetStrings(mesh->GetFieldData(), parts.Names);
      return ToLabels(array, mesh->GetNumberOfCells(), "cell", labels.Ids);
    }
  }
  if (name == Colors && (ColorsOf(mesh->GetCellData()) || ColorsOf(mesh->GetPointData())))
  {
    return LabelsOfColors(mesh, labels);
  }
  const std::string choices = Choices(mesh);
  return "the mesh has no labels \"" + name + "\"" +
    (choices.empty()
        ? ", nor others: name a .seg file (vtkMarrowSegmentReader, --segments)."
        : "; it has " + choices + ": choose one of these by its name (Labels, --labels).");
}
}
