// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOFFReader.h"

#include "FilterSupport.h"
#include "MeshBridge.h"
#include "OffFile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace
{
/// The corners of the triangles that a face of four or more corners falls into.
std::vector<vtkIdType> Triangulate(const std::vector<int>& face, vtkPoints* points)
{
  const auto size = static_cast<vtkIdType>(face.size());
  vtkNew<vtkPolygon> polygon;
  polygon->PointIds->SetNumberOfIds(size);
  polygon->Points->SetDataTypeToDouble();
  polygon->Points->SetNumberOfPoints(size);
  for (vtkIdType k = 0; k < size; ++k)
  {
    polygon->PointIds->SetId(k, face[k]);
    polygon->Points->SetPoint(k, points->GetPoint(face[k]));
  }
  std::vector<vtkIdType> corners;
  vtkNew<vtkIdList> triangles;
  if (polygon->Triangulate(triangles) && triangles->GetNumberOfIds() == 3 * (size - 2))
  {
    for (vtkIdType k = 0; k < triangles->GetNumberOfIds(); ++k)
    {
      corners.push_back(face[triangles->GetId(k)]);
    }
    return corners;
  }
  // A degenerate polygon has no ears. A fan at least keeps its edges.
  for (vtkIdType k = 1; k + 1 < size; ++k)
  {
    corners.insert(corners.end(), { face[0], face[k], face[k + 1] });
  }
  return corners;
}

vtkSmartPointer<vtkUnsignedCharArray> NewColors()
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Colors");
  colors->SetNumberOfComponents(4);
  return colors;
}

void AddPointArrays(const marrow::OffFile& file, vtkPointData* data)
{
  if (!file.Normals.empty())
  {
    marrow::SetArray(data, "Normals", file.Normals);
    data->SetActiveNormals("Normals");
  }
  if (!file.PointColors.empty())
  {
    auto colors = NewColors();
    for (const auto& color : file.PointColors)
    {
      colors->InsertNextTypedTuple(color.data());
    }
    data->AddArray(colors);
  }
  if (!file.TextureCoordinates.empty())
  {
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetName("TextureCoordinates");
    coordinates->SetNumberOfComponents(2);
    for (const auto& coordinate : file.TextureCoordinates)
    {
      coordinates->InsertNextTypedTuple(coordinate.data());
    }
    data->SetTCoords(coordinates);
  }
}
}

vtkStandardNewMacro(vtkOFFReader);

vtkOFFReader::vtkOFFReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkOFFReader::~vtkOFFReader()
{
  this->SetFileName(nullptr);
}

int vtkOFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: set FileName.");
    return 0;
  }
  marrow::OffFile file;
  const std::string error =
    marrow::ReadOffFile(this->FileName, file, marrow::ProgressOf(this, 0.0, 0.7));
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (marrow::IsAborted(this))
  {
    return 1;
  }

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(file.Points.size()));
  for (std::size_t i = 0; i < file.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), file.Points[i].data());
  }

  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdTypeArray> originalCellId;
  originalCellId->SetName("OriginalCellId");
  auto colors = NewColors();
  vtkIdType leftOut = 0;
  vtkIdType firstLeftOut = -1;
  for (std::size_t f = 0; f < file.Faces.size(); ++f)
  {
    const std::vector<int>& face = file.Faces[f];
    const auto id = static_cast<vtkIdType>(f);
    if (face.size() < 3)
    {
      firstLeftOut = leftOut++ == 0 ? id : firstLeftOut;
      continue;
    }
    const std::vector<vtkIdType> corners = face.size() == 3
      ? std::vector<vtkIdType>(face.begin(), face.end())
      : Triangulate(face, points);
    for (std::size_t k = 0; k < corners.size(); k += 3)
    {
      triangles->InsertNextCell(3, corners.data() + k);
      originalCellId->InsertNextValue(id);
      if (!file.FaceColors.empty())
      {
        colors->InsertNextTypedTuple(file.FaceColors[f].data());
      }
    }
  }
  if (leftOut > 0)
  {
    vtkWarningMacro("\"" << this->FileName << "\" has " << leftOut
                         << " faces of fewer than three corners (the first is face " << firstLeftOut
                         << "), which were left out.");
  }

  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->SetPoints(points);
  output->SetPolys(triangles);
  AddPointArrays(file, output->GetPointData());
  if (!file.FaceColors.empty())
  {
    output->GetCellData()->AddArray(colors);
  }
  const bool isRenumbered = std::any_of(file.Faces.begin(), file.Faces.end(),
    [](const std::vector<int>& face) { return face.size() != 3; });
  if (isRenumbered)
  {
    output->GetCellData()->AddArray(originalCellId);
  }
  this->UpdateProgress(1.0);
  return 1;
}

void vtkOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
