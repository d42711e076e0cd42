// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "MeshBridge.h"
#include "SurfaceShapes.h"
#include "TestMeshes.h"
#include "vtkWorkingSurface.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>

using namespace marrow;
using namespace marrow::test;

namespace
{
int Count(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  EXPECT_TRUE(array) << name;
  return array ? static_cast<int>(array->GetTuple1(0)) : -1;
}

std::string Note(vtkPolyData* data)
{
  auto* note =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("WorkingSurfaceNote"));
  return note ? std::string(note->GetValue(0)) : "no note";
}
}

TEST(WorkingSurfaceFilter, CleanMeshPassesWithItsArrays)
{
  const Creature creature = MakeCreature(vtkCreatureSource::QUADRUPED);
  vtkNew<vtkWorkingSurface> filter;
  filter->SetInputData(creature.Mesh);
  filter->Update();
  vtkPolyData* working = filter->GetOutput(0);
  EXPECT_EQ(working->GetPoints(), creature.Mesh->GetPoints());
  EXPECT_EQ(working->GetPolys(), creature.Mesh->GetPolys());
  EXPECT_EQ(working->GetCellData()->GetArray("SegmentId"),
    creature.Mesh->GetCellData()->GetArray("SegmentId"));
  EXPECT_EQ(Note(working), "");
  EXPECT_EQ(Count(working, "MergedPoints"), 0);
  std::vector<int> triangleOfCell;
  ASSERT_TRUE(GetArray(filter->GetOutput(1)->GetCellData(), "WorkingTriangleId",
    static_cast<int>(working->GetNumberOfCells()), triangleOfCell));
  for (std::size_t c = 0; c < triangleOfCell.size(); ++c)
  {
    EXPECT_EQ(triangleOfCell[c], static_cast<int>(c));
  }
}

TEST(WorkingSurfaceFilter, TakesPolygonsStripsVerticesAndLines)
{
  // The side of a cube as one strip, its ends as quadrilaterals, a line and a vertex.
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    const int top = i / 4;
    points->InsertNextPoint(i / 2 == 1 || i / 2 == 2, top, i % 2);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->AllocateEstimate(4, 4);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 7 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 6, 4, 2 });
  polygons->InsertNextCell({ 1, 3, 5, 7 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3, 4, 5, 6, 7, 0, 1 });
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  vtkNew<vtkWorkingSurface> filter;
  ErrorObserver errors(filter);
  filter->SetInputData(mesh);
  filter->Update();
  EXPECT_EQ(errors.Text(), "");
  TriangleMesh working;
  ASSERT_EQ(ToTriangleMesh(filter->GetOutput(0), working), "");
  EXPECT_EQ(CheckMesh(working).ManifoldError(), "");
  EXPECT_TRUE(CheckMesh(working).IsClosed());
  EXPECT_EQ(working.NumberOfTriangles(), 12);
  EXPECT_NEAR(std::abs(SignedVolume(working)), 1.0, 1e-12);
  std::vector<int> triangleOfCell;
  ASSERT_TRUE(
    GetArray(filter->GetOutput(1)->GetCellData(), "WorkingTriangleId", 5, triangleOfCell));
  EXPECT_EQ(triangleOfCell[0], -1);
  EXPECT_EQ(triangleOfCell[1], -1);
  EXPECT_GE(triangleOfCell[2], 0);
  EXPECT_GE(triangleOfCell[4], 0);
  EXPECT_EQ(Count(filter->GetOutput(1), "NumberOfOtherCells"), 2);
  EXPECT_NE(
    Note(filter->GetOutput(0)).find("passed over 2 vertex and line cells"), std::string::npos);
}

TEST(WorkingSurfaceFilter, SaysWhatItDidAndDoesNotWarn)
{
  PolygonMesh seams = Exploded(ToPolygons(MakeSphere(1.0, 3)));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& point : seams.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (int c = 0; c < seams.NumberOfPolygons(); ++c)
  {
    polygons->InsertNextCell({ 3 * c, 3 * c + (c == 5 ? 2 : 1), 3 * c + (c == 5 ? 1 : 2) });
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  vtkNew<vtkWorkingSurface> filter;
  ErrorObserver errors(filter);
  filter->SetInputData(mesh);
  filter->Update();
  EXPECT_EQ(errors.Text(), "");
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_EQ(Note(filter->GetOutput(port)), "merged 1,278 equal points, turned 1 face");
    EXPECT_EQ(Count(filter->GetOutput(port), "MergedPoints"), 1278);
    EXPECT_EQ(Count(filter->GetOutput(port), "TurnedFaces"), 1);
  }
  EXPECT_EQ(filter->GetOutput(1)->GetPoints(), points.Get());
}

TEST(WorkingSurfaceFilter, BoundsTheSizeAndIsTheSameOnAnyNumberOfThreads)
{
  PolygonMesh unused;
  auto mesh = ToPolyData(MakeTorus(3.0, 1.0, 100, 50));
  vtkNew<vtkWorkingSurface> filter;
  filter->SetInputData(mesh);
  filter->SetMaximumFaces(2000);
  filter->Update();
  EXPECT_LE(filter->GetOutput(0)->GetNumberOfCells(), 2000);
  EXPECT_EQ(Note(filter->GetOutput(0)), "simplified 10,000 triangles to 2,000");
  TriangleMesh first;
  ToTriangleMesh(filter->GetOutput(0), first);
  vtkSMPTools::Initialize(1);
  filter->Modified();
  filter->Update();
  vtkSMPTools::Initialize(0);
  TriangleMesh second;
  ToTriangleMesh(filter->GetOutput(0), second);
  EXPECT_TRUE(first.Points == second.Points && first.Triangles == second.Triangles);
}

TEST(WorkingSurfaceFilter, UnitsOfAnySizeGiveTheSameSurface)
{
  const TriangleMesh torus = MakeTorus(3.0, 1.0, 60, 30);
  const WorkingSurface one = Compute(ToPolygons(torus), 1000);
  for (const int exponent : { -100, -400, 100, 300 })
  {
    const double factor = std::ldexp(1.0, exponent);
    const WorkingSurface scaled = Compute(ToPolygons(Scaled(torus, factor)), 1000);
    EXPECT_EQ(scaled.Mesh.Triangles, one.Mesh.Triangles) << exponent;
    EXPECT_EQ(scaled.Mesh.Points[7] / factor, one.Mesh.Points[7]);
  }
}

TEST(WorkingSurfaceFilter, ErrorsAreOneSentence)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkWorkingSurface> filter;
  ErrorObserver errors(filter);
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(errors.HasError("The mesh has no face: connect a surface.")) << errors.Text();
}
