// SPDX-License-Identifier: BSD-3-Clause
#include "TestShapes.h"
#include "WindingNumber.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// Two triangles of a unit square, a border all round.
TriangleMesh Square()
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  mesh.BuildConnectivity();
  return mesh;
}
}

TEST(TriangleMesh, OppositeHalfEdgesRunTheSameEdgeBackwards)
{
  const TriangleMesh mesh = MakeTorus(2.0, 0.5, 20, 12);
  for (int h = 0; h < 3 * mesh.NumberOfTriangles(); ++h)
  {
    const int opposite = mesh.Opposite[h];
    ASSERT_GE(opposite, 0);
    EXPECT_EQ(mesh.Opposite[opposite], h);
    EXPECT_EQ(mesh.From(opposite), mesh.To(h));
    EXPECT_EQ(mesh.To(opposite), mesh.From(h));
    EXPECT_EQ(TriangleMesh::Next(TriangleMesh::Previous(h)), h);
  }
}

TEST(TriangleMesh, FanVisitsEveryNeighbourOnceInOrder)
{
  const TriangleMesh mesh = MakeSphere(1.0, 2);
  std::vector<std::set<int>> neighbors(mesh.NumberOfVertices());
  for (const auto& t : mesh.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      neighbors[t[k]].insert({ t[(k + 1) % 3], t[(k + 2) % 3] });
    }
  }
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    std::vector<int> visited;
    mesh.ForEachNeighbor(v, [&](int neighbor) { visited.push_back(neighbor); });
    EXPECT_EQ(visited.size(), neighbors[v].size());
    EXPECT_EQ(std::set<int>(visited.begin(), visited.end()), neighbors[v]);
    for (std::size_t i = 0; i < visited.size(); ++i)
    {
      const int next = visited[(i + 1) % visited.size()];
      EXPECT_EQ(neighbors[visited[i]].count(next), 1u) << "not in order around vertex " << v;
    }
  }
}

TEST(TriangleMesh, BorderFanHasItsLastNeighbourToo)
{
  const TriangleMesh mesh = Square();
  std::vector<int> visited;
  mesh.ForEachNeighbor(0, [&](int neighbor) { visited.push_back(neighbor); });
  EXPECT_EQ(visited, (std::vector<int>{ 1, 2, 3 }));
  visited.clear();
  mesh.ForEachNeighbor(1, [&](int neighbor) { visited.push_back(neighbor); });
  EXPECT_EQ(visited, (std::vector<int>{ 2, 0 }));
}

TEST(TriangleMesh, UnusedPointHasNoFan)
{
  TriangleMesh mesh = Square();
  mesh.Points.push_back({ 5, 5, 5 });
  mesh.BuildConnectivity();
  EXPECT_EQ(mesh.Outgoing[4], -1);
  mesh.ForEachNeighbor(4, [](int) { FAIL() << "an unused point has no neighbour"; });
}

TEST(TriangleMesh, AreasAndNormalsOfKnownShapes)
{
  const TriangleMesh square = Square();
  EXPECT_DOUBLE_EQ(square.Area(0), 0.5);
  EXPECT_TRUE(square.AreaVector(0).isApprox(Eigen::Vector3d(0, 0, 1)));
  EXPECT_DOUBLE_EQ(square.VertexAreas()[0], 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(square.VertexAreas()[1], 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(square.BoundingBoxDiagonal(), std::sqrt(2.0));

  const TriangleMesh sphere = MakeSphere(2.0, 5);
  const std::vector<double> areas = sphere.TriangleAreas();
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 16.0 * Pi, 0.05);
  const std::vector<double> vertexAreas = sphere.VertexAreas();
  EXPECT_NEAR(std::accumulate(vertexAreas.begin(), vertexAreas.end(), 0.0), 16.0 * Pi, 0.05);
  const std::vector<Eigen::Vector3d> normals = sphere.VertexNormals();
  for (int v = 0; v < sphere.NumberOfVertices(); ++v)
  {
    EXPECT_GT(normals[v].dot(sphere.Points[v]) / 2.0, 0.9999);
  }
}

TEST(TriangleMesh, NormalWeighsByAngleNotByNumberOfTriangles)
{
  // A corner of a cube, one of its three faces cut in two at the corner.
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  mesh.Triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 4, 3 }, { 0, 1, 4 } };
  mesh.BuildConnectivity();
  const Eigen::Vector3d expected = Eigen::Vector3d(-1, -1, -1).normalized();
  EXPECT_TRUE(mesh.VertexNormals()[0].isApprox(expected, 1e-12));
}

TEST(WindingNumber, IsOneInsideHalfInTheMouthOfABowlAndNothingOutside)
{
  TriangleMesh sphere = MakeSphere(2.0, 4);
  for (auto& point : sphere.Points)
  {
    point += Eigen::Vector3d(5, 6, 7);
  }
  EXPECT_NEAR(WindingNumber(sphere, { 5, 6, 7 }), 1.0, 1e-9);
  EXPECT_NEAR(WindingNumber(sphere, { 6.5, 6, 7 }), 1.0, 1e-9);
  EXPECT_NEAR(WindingNumber(sphere, { 7.5, 6, 7 }), 0.0, 1e-9);
  auto& triangles = sphere.Triangles;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const auto& t) {
                      return (sphere.Points[t[0]] + sphere.Points[t[1]] + sphere.Points[t[2]]).z() >
                        3.0 * 7.0;
                    }),
    triangles.end());
  EXPECT_NEAR(WindingNumber(sphere, { 5, 6, 7 }), 0.5, 0.02);
}
