// SPDX-License-Identifier: BSD-3-Clause
#include "FileMeshBridge.h"

#include "ArrayNames.h"
#include "MeshBridge.h"
#include "PartNumbers.h"
#include "StringArrays.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeTraits.h>

#include <algorithm>

namespace marrow
{
namespace
{
void AddParts(
  const FileParts& parts, const char* idName, const char* nameOfNames, vtkPolyData* output)
{
  if (!parts.HasNames())
  {
    return;
  }
  const NumberedParts numbered = NumberParts(parts.NameOfPart());
  std::vector<int> ids;
  ids.reserve(parts.PartOfFace().size());
  for (const int part : parts.PartOfFace())
  {
    ids.push_back(numbered.IdOfPart[part]);
  }
  SetIntArray(output->GetCellData(), idName, ids);
  SetStrings(output->GetFieldData(), nameOfNames, numbered.NameOfId);
}

/// A vtkPolyData breaks down over polygons of fewer than three corners: these repeat their last one.
void FillCells(const FileMesh& mesh, vtkIdTypeArray* offsets, vtkIdTypeArray* corners)
{
  constexpr std::size_t LeastCorners = 3;
  const std::size_t numberOfFaces = mesh.NumberOfFaces();
  std::size_t total = 0;
  for (std::size_t face = 0; face < numberOfFaces; ++face)
  {
    total += std::max(LeastCorners, mesh.FaceStarts[face + 1] - mesh.FaceStarts[face]);
  }
  offsets->SetNumberOfValues(static_cast<vtkIdType>(numberOfFaces) + 1);
  corners->SetNumberOfValues(static_cast<vtkIdType>(total));
  vtkIdType* next = corners->GetPointer(0);
  for (std::size_t face = 0; face < numberOfFaces; ++face)
  {
    offsets->SetValue(static_cast<vtkIdType>(face), next - corners->GetPointer(0));
    const int* begin = mesh.Corners.data() + mesh.FaceStarts[face];
    const std::size_t size = mesh.FaceStarts[face + 1] - mesh.FaceStarts[face];
    next = std::copy(begin, begin + size, next);
    for (std::size_t k = size; k < LeastCorners; ++k)
    {
      *next++ = size == 0 ? 0 : begin[size - 1];
    }
  }
  offsets->SetValue(static_cast<vtkIdType>(numberOfFaces), next - corners->GetPointer(0));
}
}

void AddArrays(const std::vector<FileArray>& arrays, vtkFieldData* data)
{
  for (const FileArray& array : arrays)
  {
    const auto copy = vtk::TakeSmartPointer(std::visit(
      [&array](const auto& values)
      {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        vtkDataArray* copied = vtkDataArray::CreateDataArray(vtkTypeTraits<Value>::VTKTypeID());
        copied->SetNumberOfComponents(array.Components);
        copied->SetNumberOfTuples(static_cast<vtkIdType>(array.NumberOfTuples()));
        std::copy(values.begin(), values.end(), static_cast<Value*>(copied->GetVoidPointer(0)));
        return copied;
      },
      array.Values));
    copy->SetName(array.Name.c_str());
    data->AddArray(copy);
  }
}

void ToPolyData(const FileMesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    coordinates->SetTypedTuple(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> corners;
  FillCells(mesh, offsets, corners);
  vtkNew<vtkCellArray> faces;
  faces->SetData(offsets, corners);
  output->SetPoints(points);
  output->SetPolys(faces);
  AddArrays(mesh.PointArrays, output->GetPointData());
  output->GetPointData()->SetActiveNormals(NormalsName);
  output->GetPointData()->SetActiveTCoords(TextureCoordinatesName);
  AddArrays(mesh.FaceArrays, output->GetCellData());
  AddParts(mesh.Groups, names::GroupId, names::GroupName, output);
  AddParts(mesh.Objects, names::ObjectId, names::ObjectName, output);
  AddParts(mesh.Materials, names::MaterialId, names::MaterialName, output);
}

FileMesh ToFileMesh(vtkPolyData* input)
{
  FileMesh mesh;
  mesh.Points.resize(input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, mesh.Points[i].data());
  }
  mesh.FaceStarts.reserve(input->GetNumberOfPolys() + 1);
  mesh.Corners.reserve(input->GetPolys()->GetNumberOfConnectivityIds());
  const auto face = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (face->GoToFirstCell(); !face->IsDoneWithTraversal(); face->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    face->GetCurrentCell(size, ids);
    std::transform(ids, ids + size, std::back_inserter(mesh.Corners),
      [](vtkIdType id) { return static_cast<int>(id); });
    mesh.EndFace();
  }
  return mesh;
}
}
