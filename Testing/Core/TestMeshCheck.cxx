// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCheck.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <limits>

using namespace marrow;
using namespace marrow::test;

namespace
{
TriangleMesh Mesh(std::vector<std::array<int, 3>> triangles, int points)
{
  TriangleMesh mesh;
  for (int i = 0; i < points; ++i)
  {
    mesh.Points.push_back({ std::cos(1.0 * i), std::sin(2.0 * i), 0.1 * i });
  }
  mesh.Triangles = std::move(triangles);
  mesh.BuildConnectivity();
  return mesh;
}

TriangleMesh Union(const TriangleMesh& a, const TriangleMesh& b)
{
  TriangleMesh mesh = a;
  mesh.Points.insert(mesh.Points.end(), b.Points.begin(), b.Points.end());
  for (auto t : b.Triangles)
  {
    for (int& corner : t)
    {
      corner += a.NumberOfVertices();
    }
    mesh.Triangles.push_back(t);
  }
  mesh.BuildConnectivity();
  return mesh;
}
}

TEST(MeshCheck, ClosedSurfacesHaveTheirGenus)
{
  const MeshReport sphere = CheckMesh(MakeSphere(1.0, 2));
  EXPECT_EQ(sphere.ManifoldError(), "");
  EXPECT_EQ(sphere.ClosedError(), "");
  EXPECT_EQ(sphere.NumberOfComponents, 1);
  EXPECT_EQ(sphere.EulerCharacteristic, 2);
  EXPECT_EQ(sphere.Genus(), 0);
  EXPECT_EQ(sphere.NumberOfBorders, 0);

  const MeshReport torus = CheckMesh(MakeTorus(2.0, 0.5, 12, 8));
  EXPECT_EQ(torus.EulerCharacteristic, 0);
  EXPECT_EQ(torus.Genus(), 1);

  EXPECT_EQ(CheckMesh(MakeCylinder(1.0, 3.0, 12, 5)).Genus(), 0);
}

TEST(MeshCheck, GenusOfSeveralComponentsIsTheirSum)
{
  const MeshReport report = CheckMesh(
    Union(Union(MakeTorus(2.0, 0.5, 12, 8), MakeTorus(1.0, 0.3, 9, 7)), MakeSphere(1.0, 1)));
  EXPECT_EQ(report.NumberOfComponents, 3);
  EXPECT_EQ(report.Genus(), 2);
}

TEST(MeshCheck, HolesAreCountedAndKeepTheGenus)
{
  TriangleMesh torus = MakeTorus(2.0, 0.5, 12, 8);
  // Two holes far from each other, the second of two triangles.
  torus.Triangles.erase(torus.Triangles.begin() + 100, torus.Triangles.begin() + 102);
  torus.Triangles.erase(torus.Triangles.begin());
  torus.BuildConnectivity();
  const MeshReport report = CheckMesh(torus);
  EXPECT_EQ(report.ManifoldError(), "");
  EXPECT_FALSE(report.IsClosed());
  EXPECT_EQ(report.NumberOfBorders, 2);
  EXPECT_EQ(report.BorderEdges.Count, 3 + 4);
  EXPECT_EQ(report.Genus(), 1);
  EXPECT_EQ(report.ClosedError(),
    "The mesh has 7 border edges (the first at point " + std::to_string(report.BorderEdges.First) +
      "): close its holes first, for example with vtkFillHolesFilter.");
}

TEST(MeshCheck, NamesPointsThatAreNotFinite)
{
  TriangleMesh mesh = MakeSphere(1.0, 1);
  mesh.Points[7].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(CheckMesh(mesh).ManifoldError(),
    "The mesh has 1 point whose coordinates are not finite (at point 7): remove or repair them.");
  mesh.Points[5].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(CheckMesh(mesh).ManifoldError(),
    "The mesh has 2 points whose coordinates are not finite (the first at point 5): remove or "
    "repair them.");
}

TEST(MeshCheck, NamesTrianglesThatUseAPointTwice)
{
  EXPECT_EQ(CheckMesh(Mesh({ { 0, 1, 2 }, { 1, 3, 3 } }, 4)).ManifoldError(),
    "The mesh has 1 triangle that uses a point twice (at cell 1): run vtkCleanPolyData first.");
}

TEST(MeshCheck, NamesEdgesWithThreeTriangles)
{
  EXPECT_EQ(CheckMesh(Mesh({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, 5)).ManifoldError(),
    "The mesh has 1 edge with more than two triangles (at point 0): separate the sheets or remove "
    "the extra triangles.");
}

TEST(MeshCheck, NamesTrianglesOrientedAgainstEachOther)
{
  const MeshReport report = CheckMesh(Mesh({ { 0, 1, 2 }, { 1, 2, 3 } }, 4));
  EXPECT_EQ(report.ManifoldError(),
    "The mesh has 1 edge whose two triangles are oriented against each other (at point 1): run "
    "vtkPolyDataNormals with ConsistencyOn and SplittingOff first.");
}

TEST(MeshCheck, NamesVerticesWhereFansTouch)
{
  // Two triangles that share nothing but point 2.
  const MeshReport open = CheckMesh(Mesh({ { 0, 1, 2 }, { 2, 3, 4 } }, 5));
  EXPECT_EQ(open.ManifoldError(),
    "The mesh has 1 vertex where separate fans of triangles touch (at point 2): give each fan its "
    "own vertex.");

  // Two closed tetrahedra that share a vertex: every edge is fine.
  const MeshReport closed = CheckMesh(Mesh({ { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 },
                                             { 3, 5, 4 }, { 3, 4, 6 }, { 4, 5, 6 }, { 5, 3, 6 } },
    7));
  EXPECT_TRUE(closed.IsClosed());
  EXPECT_EQ(closed.NonManifoldVertices.Count, 1);
  EXPECT_EQ(closed.NonManifoldVertices.First, 3);
}

TEST(MeshCheck, UnusedPointsAreCountedButNoError)
{
  TriangleMesh mesh = MakeSphere(1.0, 1);
  mesh.Points.push_back({ 9, 9, 9 });
  mesh.BuildConnectivity();
  const MeshReport report = CheckMesh(mesh);
  EXPECT_EQ(report.UnusedPoints.Count, 1);
  EXPECT_EQ(report.UnusedPoints.First, mesh.NumberOfVertices() - 1);
  EXPECT_EQ(report.ManifoldError(), "");
  EXPECT_EQ(report.Genus(), 0);
}

TEST(MeshCheck, ComponentsAreNumberedByTheirFirstTriangle)
{
  const TriangleMesh mesh = Union(MakeSphere(1.0, 1), MakeSphere(2.0, 0));
  int count = 0;
  const std::vector<int> component = TriangleComponents(mesh, count);
  EXPECT_EQ(count, 2);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_EQ(component[t], t < 32 ? 0 : 1);
  }
}
