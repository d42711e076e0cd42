// SPDX-License-Identifier: BSD-3-Clause
#include "AverageGeodesicDistance.h"
#include "CoarseGeodesicDistance.h"
#include "GeodesicSolver.h"
#include "MeasureShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace marrow;
using namespace marrow::test;

namespace
{
std::vector<double> AGDOf(const TriangleMesh& mesh, int numberOfSources)
{
  std::vector<double> values;
  EXPECT_TRUE(ComputeAverageGeodesicDistance(mesh, numberOfSources, values));
  return values;
}

double MeanDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(a[i] - b[i]);
  }
  return sum / static_cast<double>(a.size());
}

/// Distances from one vertex, by vertex.
std::vector<double> DistancesFrom(const TriangleMesh& mesh, int source)
{
  const GeodesicSolver solver(mesh);
  const auto& order = solver.Order();
  const int rank = static_cast<int>(std::find(order.begin(), order.end(), source) - order.begin());
  std::vector<float> lanes;
  solver.Distances(0, { rank }, lanes);
  std::vector<double> distances(mesh.Points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    distances[order[i]] = lanes[GeodesicSolver::Lanes * i];
  }
  return distances;
}
}

TEST(GeodesicSolver, MeasuresGreatCirclesOnASphere)
{
  const double radius = 3.0;
  const TriangleMesh mesh = MakeSphere(radius, 5);
  const std::vector<double> distances = DistancesFrom(mesh, 4);
  double sum = 0.0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const double exact = radius * std::acos(std::clamp(mesh.Points[v].z() / radius, -1.0, 1.0));
    ASSERT_NEAR(distances[v], exact, 0.05 * radius) << v; // the antipode is the worst place
    sum += std::abs(distances[v] - exact);
  }
  EXPECT_LT(sum / mesh.NumberOfVertices(), 0.005 * radius);
}

TEST(GeodesicSolver, IsExactWhereTheSurfaceUnfolds)
{
  // On the side of a cylinder geodesics are straight lines of the unrolled side; edges alone would
  // be several percent too long.
  const double radius = 1.0;
  const int around = 48;
  const TriangleMesh mesh = MakeCylinder(radius, 6.0, around, 46);
  int source = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if ((mesh.Points[v] - Eigen::Vector3d(radius, 0, 0)).norm() <
      (mesh.Points[source] - Eigen::Vector3d(radius, 0, 0)).norm())
    {
      source = v;
    }
  }
  const std::vector<double> distances = DistancesFrom(mesh, source);
  const Eigen::Vector3d& from = mesh.Points[source];
  int checked = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const Eigen::Vector3d& to = mesh.Points[v];
    if (std::hypot(to.x(), to.y()) < 0.999 * radius || std::abs(to.z()) > 2.0)
    {
      continue;
    }
    double turn = std::abs(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()));
    turn = std::min(turn, 2.0 * Pi - turn);
    const double chord = 2.0 * radius * std::sin(Pi / around) * turn / (2.0 * Pi / around);
    const double exact = std::hypot(chord, to.z() - from.z());
    EXPECT_NEAR(distances[v], exact, 0.004 * exact + 1e-6) << v;
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST(AverageGeodesicDistance, GrowsWithTheSquareAlongARod)
{
  // On a thin rod of length L the mean distance from height z is (L²/4 + z²) / L.
  const double length = 10.0;
  const TriangleMesh mesh = MakeCylinder(0.03, length, 12, 300);
  for (int sources : { 64, 0 })
  {
    const std::vector<double> agd = AGDOf(mesh, sources);
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      const double z = 2.0 * mesh.Points[v].z() / length;
      ASSERT_NEAR(agd[v], z * z, 0.03) << v;
    }
  }
}

TEST(CoarseGeodesicDistance, GrowsWithTheSquareBetweenTheVerticesThatAreLeft)
{
  const double length = 10.0;
  TriangleMesh mesh = MakeCylinder(0.1, length, 24, 300);
  mesh.Points.push_back({ 0.0, 50.0, 0.0 }); // used by no triangle
  mesh.BuildConnectivity();
  std::vector<double> agd;
  ASSERT_TRUE(ComputeCoarseGeodesicDistance(mesh, 3000, 64, agd));
  double most = 0.0;
  for (int v = 0; v + 1 < mesh.NumberOfVertices(); ++v)
  {
    const double z = 2.0 * mesh.Points[v].z() / length;
    ASSERT_NEAR(agd[v], z * z, 0.04) << v;
    most = std::max(most, agd[v]);
  }
  EXPECT_EQ(most, 1.0);
  EXPECT_EQ(agd.back(), 0.0);
  EXPECT_FALSE(ComputeCoarseGeodesicDistance(mesh, 3000, 64, agd, [](double) { return false; }));
}

TEST(CoarseGeodesicDistance, ComesCloseToThatOfTheWholeMesh)
{
  const TriangleMesh mesh = MakeEgg(5);
  std::vector<double> agd;
  ASSERT_TRUE(ComputeCoarseGeodesicDistance(mesh, mesh.NumberOfTriangles() / 4, 64, agd));
  const std::vector<double> whole = AGDOf(mesh, 64);
  EXPECT_LT(MeanDifference(agd, whole), 0.01);
  EXPECT_NE(agd, whole) << "it was not simplified";
  // What is small enough stays as it is.
  ASSERT_TRUE(ComputeCoarseGeodesicDistance(mesh, mesh.NumberOfTriangles(), 64, agd));
  EXPECT_EQ(agd, whole);
}

TEST(AverageGeodesicDistance, SamplesComeCloseToAllPairs)
{
  const TriangleMesh mesh = MakeEgg(4);
  const std::vector<double> all = AGDOf(mesh, 0);
  const std::vector<double> sampled = AGDOf(mesh, 64);
  EXPECT_LT(MeanDifference(all, sampled), 0.01);
  EXPECT_EQ(*std::min_element(all.begin(), all.end()), 0.0);
  EXPECT_EQ(*std::max_element(all.begin(), all.end()), 1.0);
  // No less sources than vertices is all of them.
  EXPECT_EQ(AGDOf(mesh, mesh.NumberOfVertices()), all);
}

TEST(AverageGeodesicDistance, SamplesAreWeightedByTheirCells)
{
  // The same cylinder with one half cut far finer: unweighted samples or vertices would draw the
  // centre towards it, but only areas count.
  TriangleMesh mesh = MakeCylinder(0.3, 8.0, 24, 80);
  for (auto& p : mesh.Points)
  {
    const double s = p.z() / 8.0 + 0.5;
    p.z() = 8.0 * (s * s * (3.0 - s) / 2.0 - 0.5);
  }
  for (int sources : { 64, 0 })
  {
    const std::vector<double> agd = AGDOf(mesh, sources);
    const auto least = std::min_element(agd.begin(), agd.end()) - agd.begin();
    EXPECT_LT(std::abs(mesh.Points[least].z()), 0.2) << sources;
  }
}

TEST(AverageGeodesicDistance, DoesNotDependOnOrderPlaceOrScale)
{
  const TriangleMesh mesh = MakeEgg(4);
  const std::vector<double> agd = AGDOf(mesh, 64);
  const TriangleMesh moved = Translated(
    Scaled(Rotated(mesh, Eigen::Vector3d(1.0, -2.0, 0.5), 1.1), 1e4), Eigen::Vector3d(5e3, 1, 2));
  const std::vector<double> movedAGD = AGDOf(moved, 64);
  const PermutedMesh permuted = Permuted(mesh, 3);
  const std::vector<double> permutedAGD = AGDOf(permuted.Mesh, 64);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_NEAR(movedAGD[v], agd[v], 2e-4) << v;
    ASSERT_NEAR(permutedAGD[v], agd[permuted.OldVertex[v]], 2e-3) << v;
  }
}

TEST(AverageGeodesicDistance, IsTakenOverTheComponentOfAVertex)
{
  const TriangleMesh rod = MakeCylinder(0.1, 4.0, 12, 60);
  const TriangleMesh egg = MakeEgg(3);
  TriangleMesh both = Joined(rod, Translated(egg, Eigen::Vector3d(100.0, 0.0, 0.0)));
  both.Points.push_back({ 0.0, 50.0, 0.0 }); // used by no triangle
  both.BuildConnectivity();
  const std::vector<double> agd = AGDOf(both, 64);
  const std::vector<double> rodAGD = AGDOf(rod, 64);
  for (int v = 0; v < rod.NumberOfVertices(); ++v)
  {
    ASSERT_NEAR(agd[v], rodAGD[v], 1e-6) << v;
  }
  EXPECT_EQ(*std::max_element(agd.begin() + rod.NumberOfVertices(), agd.end()), 1.0);
  EXPECT_EQ(agd.back(), 0.0);
}

TEST(AverageGeodesicDistance, IsZeroOnABall)
{
  for (double value : AGDOf(MakeSphere(2.0, 4), 64))
  {
    ASSERT_EQ(value, 0.0);
  }
}

TEST(AverageGeodesicDistance, StandsTheSmallestMeshes)
{
  TriangleMesh triangle;
  triangle.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 3, 0 } };
  triangle.Triangles = { { 0, 1, 2 } };
  triangle.BuildConnectivity();
  const std::vector<double> agd = AGDOf(triangle, 64);
  EXPECT_EQ(agd[0], 0.0);
  EXPECT_EQ(agd[2], 1.0);

  triangle.Points[1] = triangle.Points[2] = triangle.Points[0];
  EXPECT_EQ(AGDOf(triangle, 64), std::vector<double>(3, 0.0));
}

TEST(AverageGeodesicDistance, StopsWhenAsked)
{
  std::vector<double> values;
  EXPECT_FALSE(
    ComputeAverageGeodesicDistance(MakeSphere(1.0, 2), 0, values, [](double) { return false; }));
}
