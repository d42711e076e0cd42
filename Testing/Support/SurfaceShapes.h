// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceShapes_h
#define marrow_SurfaceShapes_h

#include "MeshCheck.h"
#include "TestShapes.h"
#include "WorkingSurface.h"

#include <gtest/gtest.h>

#include <initializer_list>

/// Meshes with known defects, and what every working surface has to be.
namespace marrow::test
{
inline PolygonMesh ToPolygons(const TriangleMesh& mesh)
{
  PolygonMesh result;
  result.Points = mesh.Points;
  for (const auto& triangle : mesh.Triangles)
  {
    result.Corners.insert(result.Corners.end(), triangle.begin(), triangle.end());
    result.Offsets.push_back(static_cast<int>(result.Corners.size()));
  }
  return result;
}

inline void AddPolygon(PolygonMesh& mesh, std::initializer_list<int> corners)
{
  mesh.Corners.insert(mesh.Corners.end(), corners);
  mesh.Offsets.push_back(static_cast<int>(mesh.Corners.size()));
}

/// `added` behind what is there.
inline void Append(PolygonMesh& mesh, const PolygonMesh& added)
{
  const int firstPoint = mesh.NumberOfPoints();
  const int firstCorner = static_cast<int>(mesh.Corners.size());
  mesh.Points.insert(mesh.Points.end(), added.Points.begin(), added.Points.end());
  for (int corner : added.Corners)
  {
    mesh.Corners.push_back(corner + firstPoint);
  }
  for (int c = 1; c <= added.NumberOfPolygons(); ++c)
  {
    mesh.Offsets.push_back(added.Offsets[c] + firstCorner);
  }
}

/// A cube of edge 1 of six quadrilaterals, outwards.
inline PolygonMesh MakeCube(
  const Eigen::Vector3d& corner = Eigen::Vector3d::Zero(), double edge = 1.0)
{
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.Points.push_back(corner + edge * Eigen::Vector3d(i & 1, (i >> 1) & 1, i >> 2));
  }
  AddPolygon(mesh, { 0, 2, 3, 1 });
  AddPolygon(mesh, { 4, 5, 7, 6 });
  AddPolygon(mesh, { 0, 1, 5, 4 });
  AddPolygon(mesh, { 2, 6, 7, 3 });
  AddPolygon(mesh, { 0, 4, 6, 2 });
  AddPolygon(mesh, { 1, 3, 7, 5 });
  return mesh;
}

/// Every face with points of its own, as in an STL file.
inline PolygonMesh Exploded(const PolygonMesh& mesh)
{
  PolygonMesh result;
  result.Offsets = mesh.Offsets;
  for (int corner : mesh.Corners)
  {
    result.Corners.push_back(result.NumberOfPoints());
    result.Points.push_back(mesh.Points[corner]);
  }
  return result;
}

inline void Flip(PolygonMesh& mesh, int polygon)
{
  std::reverse(
    mesh.Corners.begin() + mesh.Offsets[polygon], mesh.Corners.begin() + mesh.Offsets[polygon + 1]);
}

inline WorkingSurface Compute(const PolygonMesh& mesh, int maximumFaces = 20000)
{
  WorkingSurface surface;
  WorkingSurfaceParameters parameters;
  parameters.MaximumFaces = maximumFaces;
  EXPECT_EQ(ComputeWorkingSurface(mesh, parameters, {}, surface), "");
  return surface;
}

inline void ExpectSame(const TriangleMesh& a, const TriangleMesh& b)
{
  EXPECT_EQ(a.Triangles, b.Triangles);
  EXPECT_EQ(a.Opposite, b.Opposite);
  EXPECT_EQ(a.Outgoing, b.Outgoing);
  EXPECT_TRUE(a.Points == b.Points);
}

/// Whatever the input was: oriented manifolds with their connectivity, no unused point, every map
/// complete and within its range, and most faces kept in place.
inline void ExpectSound(const PolygonMesh& input, const WorkingSurface& surface)
{
  for (const TriangleMesh* mesh : { &surface.Full, &surface.Mesh })
  {
    const MeshReport report = CheckMesh(*mesh);
    EXPECT_EQ(report.ManifoldError(), "");
    EXPECT_EQ(report.UnusedPoints.Count, 0);
    TriangleMesh rebuilt = *mesh;
    rebuilt.BuildConnectivity();
    EXPECT_EQ(rebuilt.Opposite, mesh->Opposite);
    EXPECT_EQ(rebuilt.Outgoing, mesh->Outgoing);
  }
  auto inRange = [](const std::vector<int>& map, int low, int end)
  { return std::all_of(map.begin(), map.end(), [&](int i) { return i >= low && i < end; }); };
  ASSERT_EQ(surface.CellOfFullTriangle.size(), surface.Full.Triangles.size());
  EXPECT_TRUE(inRange(surface.CellOfFullTriangle, -1, input.NumberOfPolygons()));
  ASSERT_EQ(surface.FullTriangleOfCell.size(), input.Offsets.size() - 1);
  EXPECT_TRUE(inRange(surface.FullTriangleOfCell, 0, surface.Full.NumberOfTriangles()));
  ASSERT_EQ(surface.PointOfFullVertex.size(), surface.Full.Points.size());
  EXPECT_TRUE(inRange(surface.PointOfFullVertex, 0, input.NumberOfPoints()));
  ASSERT_EQ(surface.TriangleOfFullTriangle.size(), surface.Full.Triangles.size());
  EXPECT_TRUE(inRange(surface.TriangleOfFullTriangle, 0, surface.Mesh.NumberOfTriangles()));
  ASSERT_EQ(surface.PointOfVertex.size(), surface.Mesh.Points.size());
  EXPECT_TRUE(inRange(surface.PointOfVertex, 0, input.NumberOfPoints()));
  ASSERT_EQ(surface.VertexOfPoint.size(), input.Points.size());
  std::vector<char> used(input.Points.size(), 0);
  for (int corner : input.Corners)
  {
    used[corner] = 1;
  }
  for (int p = 0; p < input.NumberOfPoints(); ++p)
  {
    EXPECT_EQ(surface.VertexOfPoint[p] >= 0, used[p] != 0);
    EXPECT_LT(surface.VertexOfPoint[p], surface.Mesh.NumberOfVertices());
  }
  ASSERT_EQ(surface.BodyOfTriangle.size(), surface.Mesh.Triangles.size());
  EXPECT_TRUE(inRange(surface.BodyOfTriangle, 0, surface.NumberOfBodies));
  EXPECT_EQ(surface.IsInput, surface.Sentence().empty());
}

inline void ExpectClosed(const WorkingSurface& surface, int genus, int bodies = 1)
{
  const MeshReport report = CheckMesh(surface.Mesh);
  EXPECT_EQ(report.NumberOfBorders, 0);
  EXPECT_EQ(report.Genus(), genus);
  EXPECT_EQ(report.NumberOfComponents, bodies);
  EXPECT_EQ(surface.NumberOfBodies, bodies);
  EXPECT_GT(SignedVolume(surface.Mesh), 0.0);
}
}

#endif
