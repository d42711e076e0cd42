// SPDX-License-Identifier: BSD-3-Clause
#include "NearestTriangles.h"
#include "Simplification.h"
#include "SurfaceShapes.h"
#include "TriangleTree.h"

#include <map>

using namespace marrow;
using namespace marrow::test;

namespace
{
SimplifiedMesh Simplify(const TriangleMesh& mesh, int faces)
{
  SimplifiedMesh result;
  EXPECT_TRUE(SimplifyMesh(mesh, faces, {}, result));
  FindNearest(mesh, result);
  return result;
}

double LeastShape(const TriangleMesh& mesh)
{
  double least = 1.0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    double squares = 0.0;
    for (int h = 3 * t; h < 3 * t + 3; ++h)
    {
      squares += (mesh.Points[mesh.To(h)] - mesh.Points[mesh.From(h)]).squaredNorm();
    }
    least = std::min(least, 2.0 * std::sqrt(3.0) * mesh.AreaVector(t).norm() / squares);
  }
  return least;
}

/// Largest distance of a point of `mesh` from `other`.
double Deviation(const TriangleMesh& mesh, const TriangleMesh& other)
{
  const TriangleTree tree(other);
  double largest = 0.0;
  for (const auto& point : mesh.Points)
  {
    largest = std::max(largest, std::sqrt(tree.Nearest(point).SquaredDistance));
  }
  return largest;
}
}

TEST(Simplification, KeepsTopologyShapeAndEvenness)
{
  const struct
  {
    TriangleMesh Mesh;
    int Genus;
    double Deviation;
  } cases[] = { { MakeSphere(1.0, 5), 0, 0.02 }, { MakeTorus(3.0, 1.0, 120, 50), 1, 0.07 },
    { MakeCylinder(1.0, 10.0, 48, 150), 0, 0.04 } };
  for (const auto& given : cases)
  {
    const SimplifiedMesh result = Simplify(given.Mesh, 1000);
    const MeshReport report = CheckMesh(result.Mesh);
    EXPECT_EQ(report.ManifoldError(), "");
    EXPECT_EQ(report.NumberOfBorders, 0);
    EXPECT_EQ(report.Genus(), given.Genus);
    EXPECT_EQ(report.NumberOfComponents, 1);
    EXPECT_LE(result.Mesh.NumberOfTriangles(), 1000);
    EXPECT_GE(result.Mesh.NumberOfTriangles(), 998);
    EXPECT_LT(Deviation(given.Mesh, result.Mesh), given.Deviation);
    EXPECT_GE(LeastShape(result.Mesh), 0.25);
    EXPECT_NEAR(SignedVolume(result.Mesh) / SignedVolume(given.Mesh), 1.0, 0.03);
  }
}

TEST(Simplification, BordersStayInPlace)
{
  TriangleMesh tube = MakeCylinder(1.0, 6.0, 48, 90);
  std::vector<std::array<int, 3>> side;
  for (const auto& t : tube.Triangles)
  {
    const Eigen::Vector3d middle =
      (tube.Points[t[0]] + tube.Points[t[1]] + tube.Points[t[2]]) / 3.0;
    if (std::abs(middle[2]) < 2.9999)
    {
      side.push_back(t);
    }
  }
  PolygonMesh open = ToPolygons(tube);
  open.Corners.clear();
  open.Offsets = { 0 };
  for (const auto& t : side)
  {
    AddPolygon(open, { t[0], t[1], t[2] });
  }
  const WorkingSurface surface = Compute(open, 600);
  ExpectSound(open, surface);
  EXPECT_EQ(CheckMesh(surface.Mesh).NumberOfBorders, 2);
  EXPECT_LE(surface.Mesh.NumberOfTriangles(), 600);
  double low = 0.0;
  double high = 0.0;
  for (const auto& point : surface.Mesh.Points)
  {
    low = std::min(low, point[2]);
    high = std::max(high, point[2]);
  }
  EXPECT_NEAR(low, -3.0, 1e-12);
  EXPECT_NEAR(high, 3.0, 1e-12);
}

TEST(Simplification, MapsToTheNearestTriangleAlongTheSurface)
{
  const TriangleMesh mesh = MakeSphere(1.0, 5);
  const SimplifiedMesh result = Simplify(mesh, 500);
  const TriangleTree tree(result.Mesh);
  int nearest = 0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Eigen::Vector3d middle = mesh.Centroid(t);
    const auto& c = result.Mesh.Triangles[result.TriangleOfOld[t]];
    const double distance = (NearestOnTriangle(middle, result.Mesh.Points[c[0]],
                               result.Mesh.Points[c[1]], result.Mesh.Points[c[2]]) -
      middle)
                              .norm();
    nearest += distance <= std::sqrt(tree.Nearest(middle).SquaredDistance) + 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(nearest, mesh.NumberOfTriangles());
  for (int v = 0; v < result.Mesh.NumberOfVertices(); ++v)
  {
    EXPECT_EQ(result.Mesh.Points[v], mesh.Points[result.OldVertex[v]]);
    EXPECT_EQ(result.VertexOfOld[result.OldVertex[v]], v);
  }
}

TEST(Simplification, DoesNotDependOnTheOrderOfTheFile)
{
  // No two edges of it are alike, so no tie is to break.
  TriangleMesh mesh = MakeTorus(3.0, 1.0, 60, 30);
  std::mt19937 random(5);
  for (auto& point : mesh.Points)
  {
    for (int k = 0; k < 3; ++k)
    {
      point[k] *= 1.0 + 0.002 * (random() % 1000) / 1000.0;
    }
  }
  const PermutedMesh permuted = Permuted(mesh, 11);
  auto places = [](const TriangleMesh& simplified)
  {
    std::vector<std::array<double, 3>> result;
    for (const auto& p : simplified.Points)
    {
      result.push_back({ p[0], p[1], p[2] });
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  EXPECT_EQ(places(Simplify(mesh, 800).Mesh), places(Simplify(permuted.Mesh, 800).Mesh));
}

TEST(Simplification, FarFromTheOriginAsNearIt)
{
  const TriangleMesh mesh = MakeSphere(1.0, 4);
  const TriangleMesh far = Translated(mesh, { 524288.0, 4194304.0, 1024.0 });
  EXPECT_LT(
    Deviation(far, Simplify(far, 300).Mesh), 1.5 * Deviation(mesh, Simplify(mesh, 300).Mesh));
}

TEST(Simplification, StopsWhereTopologyNeedsTheTriangles)
{
  // Nothing is left below a tetrahedron.
  const SimplifiedMesh result = Simplify(MakeSphere(1.0, 2), 1);
  EXPECT_GE(result.Mesh.NumberOfTriangles(), 4);
  EXPECT_EQ(CheckMesh(result.Mesh).ManifoldError(), "");
  EXPECT_EQ(CheckMesh(result.Mesh).Genus(), 0);
}

TEST(Simplification, AbortsAtOnce)
{
  SimplifiedMesh result;
  int calls = 0;
  EXPECT_FALSE(SimplifyMesh(
    MakeSphere(1.0, 5), 100, [&](double) { return ++calls < 3; }, result));
  EXPECT_EQ(calls, 3);
}
