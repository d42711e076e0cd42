// SPDX-License-Identifier: BSD-3-Clause
#include "MeasureShapes.h"
#include "SurfaceMeasures.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// Six equilateral triangles of side 1 around vertex 0.
TriangleMesh MakeHexagon()
{
  TriangleMesh mesh;
  mesh.Points.push_back({ 0, 0, 0 });
  for (int i = 0; i < 6; ++i)
  {
    mesh.Points.push_back({ std::cos(Pi / 3.0 * i), std::sin(Pi / 3.0 * i), 0.0 });
    mesh.Triangles.push_back({ 0, i + 1, (i + 1) % 6 + 1 });
  }
  mesh.BuildConnectivity();
  return mesh;
}

TriangleMesh Flipped(TriangleMesh mesh)
{
  for (auto& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  mesh.BuildConnectivity();
  return mesh;
}
}

TEST(DihedralAngle, IsPositiveOnConvexAndNegativeOnConcaveEdges)
{
  const TriangleMesh octahedron = MakeSphere(1.0, 0);
  for (double angle : VertexDihedralAngles(octahedron))
  {
    EXPECT_NEAR(angle, std::acos(1.0 / 3.0), 1e-12);
  }
  for (double angle : VertexDihedralAngles(Flipped(octahedron)))
  {
    EXPECT_NEAR(angle, -std::acos(1.0 / 3.0), 1e-12);
  }
}

TEST(DihedralAngle, WeighsEdgesByLengthAndLeavesBordersOut)
{
  // A roof: two triangles that meet in one edge at a right angle. Every vertex on the ridge has one
  // inner edge, the others none.
  TriangleMesh roof;
  roof.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, -1 }, { 0, -1, -1 } };
  roof.Triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
  roof.BuildConnectivity();
  const std::vector<double> angles = VertexDihedralAngles(roof);
  EXPECT_NEAR(angles[0], Pi / 2.0, 1e-12);
  EXPECT_NEAR(angles[1], Pi / 2.0, 1e-12);
  EXPECT_EQ(angles[2], 0.0);
  EXPECT_EQ(angles[3], 0.0);
}

TEST(DihedralAngle, IsZeroOnFlatAndCollapsedTriangles)
{
  TriangleMesh hexagon = MakeHexagon();
  EXPECT_NEAR(VertexDihedralAngles(hexagon)[0], 0.0, 1e-12);
  hexagon.Points[1] = hexagon.Points[0];
  for (double angle : VertexDihedralAngles(hexagon))
  {
    EXPECT_TRUE(std::isfinite(angle));
  }
}

TEST(VertexGradient, FollowsThePapersSumOverTheEdgesOfTheStar)
{
  // Twelve unit edges in six directions around the circle and an area of 6 √3/4: a linear function
  // of gradient g gives 12/2 g / (6 √3/4) = 4/√3 g.
  const TriangleMesh mesh = MakeHexagon();
  const Eigen::Vector3d slope(0.3, -0.8, 0.0);
  std::vector<double> function;
  for (const auto& point : mesh.Points)
  {
    function.push_back(5.0 + slope.dot(point));
  }
  const Eigen::Vector3d gradient = VertexGradient(mesh, function)[0];
  EXPECT_LT((gradient - 4.0 / std::sqrt(3.0) * slope).norm(), 1e-12);
}

TEST(VertexGradient, KeepsItsValueUnderScaleAndVanishesOnConstants)
{
  const TriangleMesh mesh = MakeEgg(3);
  const TriangleMesh scaled = Scaled(mesh, 250.0);
  std::vector<double> function;
  std::vector<double> scaledFunction;
  for (const auto& point : mesh.Points)
  {
    function.push_back(point.z() * point.x());
    scaledFunction.push_back(250.0 * function.back());
  }
  const auto gradient = VertexGradient(mesh, function);
  const auto scaledGradient = VertexGradient(scaled, scaledFunction);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_LT((gradient[v] - scaledGradient[v]).norm(), 1e-9) << v;
  }
  for (const auto& g : VertexGradient(mesh, std::vector<double>(mesh.Points.size(), 3.0)))
  {
    ASSERT_EQ(g.norm(), 0.0);
  }
}

TEST(LeastBendingDirections, RunAlongACylinder)
{
  const TriangleMesh mesh = MakeCylinder(1.0, 10.0, 36, 60);
  const auto normals = mesh.VertexNormals();
  const auto directions = LeastBendingDirections(mesh, normals);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_NEAR(directions[v].norm(), 1.0, 1e-12) << v;
    ASSERT_NEAR(directions[v].dot(normals[v]), 0.0, 1e-12) << v;
    if (std::abs(mesh.Points[v].z()) < 4.0)
    {
      ASSERT_GT(std::abs(directions[v].z()), 0.999) << v;
    }
  }
}

TEST(LeastBendingDirections, LookAwayFromTheCentroidWhereTheSurfaceIsFlat)
{
  // A long strip of flat grid: nothing bends, the direction from the middle decides.
  TriangleMesh mesh;
  for (int i = 0; i < 21; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      mesh.Points.push_back({ i - 10.0, j - 1.0, 0.0 });
      if (i > 0 && j > 0)
      {
        const int d = 3 * i + j;
        mesh.Triangles.push_back({ d - 4, d - 1, d });
        mesh.Triangles.push_back({ d - 4, d, d - 3 });
      }
    }
  }
  mesh.BuildConnectivity();
  const auto directions = LeastBendingDirections(mesh, mesh.VertexNormals());
  EXPECT_NEAR(std::abs(directions[1].x()), 1.0, 1e-9); // (-10, 0)
  const Eigen::Vector3d corner = Eigen::Vector3d(10.0, 1.0, 0.0).normalized();
  EXPECT_NEAR(std::abs(directions[62].dot(corner)), 1.0, 1e-9);
}
