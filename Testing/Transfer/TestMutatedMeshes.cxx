// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "MutatedMeshes.h"
#include "TransferTestData.h"

#include <vtkCellArray.h>
#include <vtkMSPField.h>
#include <vtkPoints.h>
#include <vtkWorkingSurface.h>

#include <cmath>
#include <iostream>
#include <set>

using namespace marrow;
using namespace marrow::test;

namespace
{
Data ToPolyData(const PolygonMesh& mesh)
{
  auto data = Data::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (int c = 0; c < mesh.NumberOfPolygons(); ++c)
  {
    polygons->InsertNextCell(mesh.SizeOf(c));
    for (int k = 0; k < mesh.SizeOf(c); ++k)
    {
      polygons->InsertCellPoint(mesh.CornersOf(c)[k]);
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

/// True if nothing is wrong; else one sentence says what no program can mend.
bool IsDone(const ErrorObserver& errors, bool hasNaN)
{
  EXPECT_EQ(errors.HasError("not finite"), hasNaN) << errors.Text();
  EXPECT_TRUE(
    errors.Errors.empty() || hasNaN || errors.HasError("None of the mesh's faces has an area"))
    << errors.Text();
  return errors.Errors.empty();
}

/// Wraps of the default size take a second each, far more than all else that is done to meshes so small.
constexpr int FewFaces = 200;

void ExpectMeasured(vtkPolyData* mesh, bool hasNaN)
{
  vtkNew<vtkMSPField> field;
  ErrorObserver errors(field);
  field->SetMaximumFaces(FewFaces);
  field->SetInputData(mesh);
  field->Update();
  if (!IsDone(errors, hasNaN))
  {
    return;
  }
  vtkDataArray* perimeters = field->GetOutput()->GetPointData()->GetArray(names::MSP);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(std::isfinite(perimeters->GetTuple1(i))) << "point " << i;
  }
}

void ExpectSkeleton(vtkPolyData* mesh, bool hasNaN)
{
  vtkNew<vtkMSPSkeleton> filter;
  ErrorObserver errors(filter);
  filter->SetMaximumFaces(FewFaces);
  filter->SetInputData(mesh);
  filter->Update();
  if (!IsDone(errors, hasNaN))
  {
    return;
  }
  vtkPolyData* skeleton = filter->GetOutput();
  ASSERT_GT(skeleton->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < skeleton->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(Eigen::Vector3d(skeleton->GetPoint(i)).allFinite()) << "node " << i;
  }
}

void ExpectLabelled(const Prepared& source, vtkPolyData* mesh, bool hasNaN)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  ErrorObserver errors(transfer);
  transfer->SetInputData(0, source.Mesh);
  transfer->SetInputData(1, mesh);
  transfer->SetInputData(2, source.Skeleton);
  transfer->Update();
  if (!IsDone(errors, hasNaN))
  {
    return;
  }
  const std::vector<int> sourceLabels = LabelsOf(source.Mesh);
  const std::set<int> known(sourceLabels.begin(), sourceLabels.end());
  const std::vector<int> labels = LabelsOf(Output(transfer));
  ASSERT_EQ(static_cast<vtkIdType>(labels.size()), mesh->GetNumberOfCells());
  for (const int label : labels)
  {
    ASSERT_TRUE(known.count(label)) << label;
  }
}

/// Labels the mesh as vtkWorkingSurface mends it.
void ExpectMendedIsLabelled(const Prepared& source, vtkPolyData* mesh, bool hasNaN)
{
  vtkNew<vtkWorkingSurface> surface;
  ErrorObserver errors(surface);
  surface->SetMaximumFaces(FewFaces);
  surface->SetInputData(mesh);
  surface->Update();
  if (IsDone(errors, hasNaN))
  {
    ExpectLabelled(source, surface->GetOutput(), false);
  }
}
}

/// Whatever is done to a mesh, it is measured, has a skeleton, and is labelled face by face.
TEST(MutatedMeshes, AreMeasuredAndLabelled)
{
  CreatureOptions options;
  options.Faces = 2000;
  std::vector<Prepared> sources;
  for (const int shape : { vtkCreatureSource::QUADRUPED, vtkCreatureSource::CAPSULE,
         vtkCreatureSource::SNAKE, vtkCreatureSource::TORUS })
  {
    sources.push_back(Prepare(MakeCreature(shape, options).Mesh));
  }
  const MutatedMeshSeeds seeds(60);
  for (int seed = seeds.First; seed < seeds.End && !HasFailure(); ++seed)
  {
    std::string what;
    const PolygonMesh polygons = MakeMutatedMesh(seed, what);
    SCOPED_TRACE(what);
    // A sanitizer ends the program at once: the last line says at which mesh.
    std::cout << what << std::endl;
    const bool hasNaN = HasNaN(polygons);
    const Data mesh = ToPolyData(polygons);
    // Each of MakeMutatedMesh's six meshes meets each source.
    const Prepared& source = sources[seed / 6 % sources.size()];
    ExpectMeasured(mesh, hasNaN);
    ExpectSkeleton(mesh, hasNaN);
    ExpectMendedIsLabelled(source, mesh, hasNaN);
    if (seed % 50 == 0)
    {
      // As it comes, at the default size.
      ExpectLabelled(source, mesh, hasNaN);
    }
  }
}
