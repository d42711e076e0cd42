// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBridge.h"

#include "MeshCheck.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

namespace marrow
{
namespace
{
template <typename Array, typename Value>
void SetScalars(vtkDataSetAttributes* data, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  data->RemoveArray(name);
  data->AddArray(array);
}

vtkDataArray* Find(vtkDataSetAttributes* data, const char* name, int size, int components)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfTuples() == size && array->GetNumberOfComponents() == components
    ? array
    : nullptr;
}

template <typename Value>
bool GetScalars(vtkDataSetAttributes* data, const char* name, int size, std::vector<Value>& values)
{
  vtkDataArray* array = Find(data, name, size, 1);
  if (!array)
  {
    return false;
  }
  values.resize(size);
  for (int i = 0; i < size; ++i)
  {
    values[i] = static_cast<Value>(array->GetTuple1(i));
  }
  return true;
}
}

std::string ToTriangleMesh(vtkPolyData* input, TriangleMesh& mesh)
{
  if (!input || input->GetNumberOfPoints() == 0 || input->GetNumberOfCells() == 0)
  {
    return "The mesh is empty: it has no points or no cells; connect a surface of triangles.";
  }
  if (input->GetNumberOfVerts() > 0 || input->GetNumberOfLines() > 0 ||
    input->GetNumberOfStrips() > 0)
  {
    return "The mesh has " + std::to_string(input->GetNumberOfVerts()) + " vertex, " +
      std::to_string(input->GetNumberOfLines()) + " line and " +
      std::to_string(input->GetNumberOfStrips()) +
      " strip cells beside its polygons: run vtkTriangleFilter with PassVertsOff and PassLinesOff "
      "first.";
  }

  mesh.Points.resize(input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, mesh.Points[i].data());
  }

  mesh.Triangles.clear();
  mesh.Triangles.reserve(input->GetNumberOfPolys());
  Defect polygons;
  Defect invalid;
  auto iterator = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    if (size != 3)
    {
      polygons.Add(static_cast<int>(iterator->GetCurrentCellId()));
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      if (ids[k] < 0 || ids[k] >= input->GetNumberOfPoints())
      {
        invalid.Add(static_cast<int>(iterator->GetCurrentCellId()));
        break;
      }
      if (!mesh.Points[ids[k]].allFinite())
      {
        return "The mesh has points whose coordinates are not finite (the first in use is point " +
          std::to_string(ids[k]) + "): remove or repair them.";
      }
    }
    mesh.Triangles.push_back(
      { static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]) });
  }
  if (polygons.Count > 0)
  {
    return "The mesh has " + std::to_string(polygons.Count) +
      " polygons that are not triangles (the first is cell " + std::to_string(polygons.First) +
      "): run vtkTriangleFilter first.";
  }
  if (invalid.Count > 0)
  {
    return "The mesh has " + std::to_string(invalid.Count) +
      " triangles that name a point that does not exist (the first is cell " +
      std::to_string(invalid.First) + "): repair the cells.";
  }
  mesh.BuildConnectivity();
  return {};
}

void SetArray(vtkDataSetAttributes* data, const char* name, const std::vector<double>& values)
{
  SetScalars<vtkDoubleArray>(data, name, values);
}

void SetArray(
  vtkDataSetAttributes* data, const char* name, const std::vector<Eigen::Vector3d>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), values[i].data());
  }
  data->RemoveArray(name);
  data->AddArray(array);
}

void SetArray(
  vtkDataSetAttributes* data, const char* name, const std::vector<unsigned char>& values)
{
  SetScalars<vtkUnsignedCharArray>(data, name, values);
}

void SetIntArray(vtkDataSetAttributes* data, const char* name, const std::vector<int>& values)
{
  SetScalars<vtkIntArray>(data, name, values);
  data->GetArray(name)->SetMaxDiscreteValues(MostLabels);
}

void SetIdArray(vtkDataSetAttributes* data, const char* name, const std::vector<int>& values)
{
  SetScalars<vtkIdTypeArray>(data, name, values);
  data->GetArray(name)->SetMaxDiscreteValues(MostLabels);
}

bool GetArray(vtkDataSetAttributes* data, const char* name, int size, std::vector<double>& values)
{
  return GetScalars(data, name, size, values);
}

bool GetArray(
  vtkDataSetAttributes* data, const char* name, int size, std::vector<Eigen::Vector3d>& values)
{
  vtkDataArray* array = Find(data, name, size, 3);
  if (!array)
  {
    return false;
  }
  values.resize(size);
  for (int i = 0; i < size; ++i)
  {
    array->GetTuple(i, values[i].data());
  }
  return true;
}

bool GetArray(
  vtkDataSetAttributes* data, const char* name, int size, std::vector<unsigned char>& values)
{
  return GetScalars(data, name, size, values);
}

bool GetArray(vtkDataSetAttributes* data, const char* name, int size, std::vector<int>& values)
{
  return GetScalars(data, name, size, values);
}
}
