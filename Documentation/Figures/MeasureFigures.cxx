// SPDX-License-Identifier: BSD-3-Clause
#include "Constants.h"
#include "Figures.h"
#include "MeshBridge.h"

#include <vtkCellData.h>
#include <vtkCutter.h>
#include <vtkMSPField.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataConnectivityFilter.h>

#include <Eigen/Geometry>

namespace figures
{
namespace
{
Data Measured(vtkPolyData* mesh, int slices = 12)
{
  vtkNew<vtkMSPField> field;
  field->SetInputData(mesh);
  field->SetNumberOfSlices(slices);
  field->Update();
  return Output(field);
}

Eigen::Vector3d VectorAt(vtkPolyData* mesh, const char* array, vtkIdType point)
{
  return Eigen::Vector3d(mesh->GetPointData()->GetArray(array)->GetTuple3(point));
}

vtkIdType Nearest(vtkPolyData* mesh, const Eigen::Vector3d& place)
{
  return mesh->FindPoint(place.x(), place.y(), place.z());
}

/// The part of the mesh's cut by a plane that hangs together with the plane's origin.
Data Slice(vtkPolyData* mesh, const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.x(), origin.y(), origin.z());
  plane->SetNormal(normal.x(), normal.y(), normal.z());
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(mesh);
  cutter->SetCutFunction(plane);
  vtkNew<vtkPolyDataConnectivityFilter> piece;
  piece->SetInputConnection(cutter->GetOutputPort());
  piece->SetExtractionModeToClosestPointRegion();
  piece->SetClosestPoint(origin.x(), origin.y(), origin.z());
  piece->Update();
  return Output(piece);
}

/// A vertex of the leg and one of the back: all slices, and the least one.
Picture DrawSlices(const std::string&)
{
  const Data mesh = Measured(Plain(Creature(vtkCreatureSource::QUADRUPED, 1)));
  marrow::TriangleMesh plain;
  marrow::ToTriangleMesh(mesh, plain);
  const std::vector<Eigen::Vector3d> normals = plain.VertexNormals();
  const double diagonal = mesh->GetLength();
  const auto scene = Scene(400, 300);
  const std::pair<const char*, Eigen::Vector3d> places[] = { { "on a leg", { 0.53, 0.4, 0.35 } },
    { "on the trunk", { 0.05, 1.0, 0.35 } } };
  for (const auto& [caption, place] : places)
  {
    const int tile = scene->AddMesh(mesh, nullptr, caption);
    scene->SetTileOpacity(tile, 0.35);
    const vtkIdType vertex = Nearest(mesh, place);
    const Eigen::Vector3d origin(mesh->GetPoint(vertex));
    const Eigen::Vector3d least = VectorAt(mesh, "MSPNormal", vertex);
    for (int k = 0; k < 12; ++k)
    {
      const Eigen::Vector3d normal =
        Eigen::AngleAxisd(k * marrow::Pi / 12, normals[vertex]) * least;
      const Data slice = Slice(mesh, origin, normal);
      if (k == 0)
      {
        scene->AddCurves(tile, slice, Vermilion[0], Vermilion[1], Vermilion[2], 0.005);
      }
      else
      {
        scene->AddCurves(tile, slice, 0.35, 0.35, 0.35, 0.0012);
      }
    }
    scene->AddActor(tile, Ball(origin, 0.01 * diagonal, Black));
    scene->AddActor(tile, Ball(VectorAt(mesh, "MSPCenter", vertex), 0.012 * diagonal, Blue));
  }
  return Drawn(scene);
}

Picture DrawMeasures(const std::string& meshes)
{
  const Data mesh = Measured(ReadMesh(meshes, "camel"));
  const auto scene = Scene(250, 280);
  for (const char* name : { "AGD", "MSP", "MSPGradient" })
  {
    scene->SetSurfaceArray(scene->AddMesh(mesh), name);
  }
  return Drawn(scene);
}

Picture DrawNumberOfSlices(const std::string& meshes)
{
  const Data mesh = ReadMesh(meshes, "camel");
  const auto scene = Scene(250, 280);
  scene->ShareRangeOn();
  for (const int slices : { 2, 12, 90 })
  {
    const std::string caption = std::to_string(slices) + " slices";
    scene->SetSurfaceArray(scene->AddMesh(Measured(mesh, slices), nullptr, caption.c_str()), "MSP");
  }
  return Drawn(scene);
}
}

Drawings MeasureFigures()
{
  return { { "slices", DrawSlices }, { "measures", DrawMeasures },
    { "parameter-number-of-slices", DrawNumberOfSlices } };
}
}
