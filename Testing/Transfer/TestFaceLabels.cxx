// SPDX-License-Identifier: BSD-3-Clause
#include "EdgePrices.h"
#include "FaceLabels.h"
#include "LabelCleanUp.h"
#include "TestShapes.h"
#include "TubeShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace marrow;

namespace
{
/// A tube along z with a waist at z = 0.3.
TriangleMesh WaistedTube(int around, int along)
{
  TriangleMesh mesh = test::MakeCylinder(1.0, 6.0, around, along);
  for (Eigen::Vector3d& point : mesh.Points)
  {
    const double waist = 1.0 - 0.25 * std::exp(-0.5 * std::pow((point.z() - 0.3) / 0.2, 2.0));
    point.head<2>() *= waist;
  }
  return mesh;
}

/// Segment 1 above z = 0 by little more than chance, and surely far above it.
Eigen::MatrixXd TwoHalves(const TriangleMesh& mesh)
{
  Eigen::MatrixXd shares(mesh.NumberOfVertices(), 2);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    shares(v, 1) = 1.0 / (1.0 + std::exp(-5.0 * mesh.Points[v].z()));
    shares(v, 0) = 1.0 - shares(v, 1);
  }
  return shares;
}

std::vector<double> PlainPrices(const TriangleMesh& mesh)
{
  return EdgePrices(mesh, std::vector<double>(mesh.Opposite.size(), 0.0), 0.0);
}

/// Mean z of the edges between faces of different label.
double HeightOfBoundary(const TriangleMesh& mesh, const std::vector<int>& labels)
{
  double sum = 0.0;
  int count = 0;
  for (int h = 0; h < static_cast<int>(mesh.Opposite.size()); ++h)
  {
    const int opposite = mesh.Opposite[h];
    if (opposite > h &&
      labels[TriangleMesh::TriangleOf(h)] != labels[TriangleMesh::TriangleOf(opposite)])
    {
      sum += mesh.Points[mesh.From(h)].z();
      ++count;
    }
  }
  return sum / count;
}
}

TEST(EdgeConcavity, IsTheTurnOfTheNormalsInwardAtAnyResolution)
{
  for (const int around : { 48, 96 })
  {
    const TriangleMesh mesh = WaistedTube(around, 2 * around);
    const std::vector<double> concavity = EdgeConcavity(mesh, MeshSmoother(mesh, 0.05));
    double sum = 0.0;
    int count = 0;
    for (int h = 0; h < static_cast<int>(concavity.size()); ++h)
    {
      const Eigen::Vector3d& p = mesh.Points[mesh.From(h)];
      const Eigen::Vector3d& q = mesh.Points[mesh.To(h)];
      if (mesh.Opposite[h] < h || std::abs(p.z() + 1.5) < 0.5)
      {
        // Straight one way, convex the other.
        EXPECT_NEAR(concavity[h], 0.0, 1e-3);
      }
      else if (std::abs(p.z() - q.z()) < 1e-9 && std::abs(p.z() - 0.3) < 0.05)
      {
        sum += concavity[h];
        ++count;
      }
    }
    ASSERT_GT(count, 0);
    // The profile's curvature there is 0.25 / 0.2² = 6.25 a unit; smoothing takes a fifth of it.
    EXPECT_NEAR(sum / count, 0.05 * 6.25 * 0.8, 0.06) << around;
  }
}

TEST(ConcavityPreference, IsWhatTheBoundariesSay)
{
  const TriangleMesh mesh = WaistedTube(48, 96);
  const std::vector<double> concavity = EdgeConcavity(mesh, MeshSmoother(mesh, 0.05));
  const auto cutAt = [&](double height)
  {
    std::vector<int> labels;
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      labels.push_back(mesh.Centroid(t).z() > height ? 1 : 0);
    }
    return ConcavityPreference(mesh, concavity, labels);
  };
  EXPECT_GT(cutAt(0.3), 10.0);
  EXPECT_LT(cutAt(-1.5), 0.1);
  // No boundary says nothing.
  EXPECT_LT(cutAt(10.0), 0.1);
}

TEST(EdgePrices, LengthOverDiagonalAndCheapWhereConcave)
{
  const TriangleMesh mesh = WaistedTube(48, 96);
  std::vector<double> concavity(mesh.Opposite.size(), 0.0);
  concavity[0] = 0.2;
  concavity[1] = 1.0;
  const std::vector<double> prices = EdgePrices(mesh, concavity, 5.0);
  const auto length = [&](int h)
  { return (mesh.Points[mesh.From(h)] - mesh.Points[mesh.To(h)]).norm(); };
  const double diagonal = mesh.BoundingBoxDiagonal();
  EXPECT_NEAR(prices[0], std::exp(-1.0) * length(0) / diagonal, 1e-12);
  EXPECT_NEAR(prices[1], 0.05 * length(1) / diagonal, 1e-12);
  EXPECT_NEAR(prices[2], length(2) / diagonal, 1e-12);
  EXPECT_EQ(prices[mesh.Opposite[2]], 0.0);
}

TEST(FaceLabels, ABoundaryIsDrawnIntoAConcavity)
{
  const TriangleMesh mesh = WaistedTube(48, 120);
  const std::vector<double> concavity = EdgeConcavity(mesh, MeshSmoother(mesh, 0.05));
  EXPECT_NEAR(HeightOfBoundary(
                mesh, LabelFaces(mesh, TwoHalves(mesh), EdgePrices(mesh, concavity, 10.0), {}, {})),
    0.3, 0.1);
  // Where nothing draws it, it stays where the segments meet.
  const TriangleMesh straight = test::MakeCylinder(1.0, 6.0, 48, 120);
  const std::vector<int> labels =
    LabelFaces(straight, TwoHalves(straight), PlainPrices(straight), {}, {});
  EXPECT_NEAR(HeightOfBoundary(straight, labels), 0.0, 0.06);
}

TEST(FaceLabels, ASmallSegmentIsNotSwallowed)
{
  const TriangleMesh mesh = test::MakeCylinder(1.0, 6.0, 32, 60);
  Eigen::MatrixXd shares(mesh.NumberOfVertices(), 2);
  int inside = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    // A spot of a few faces that is hardly surer than its surroundings.
    const double distance = (mesh.Points[v] - Eigen::Vector3d(1.0, 0.0, 0.0)).norm();
    shares(v, 1) = distance < 0.25 ? 0.6 : 0.0;
    shares(v, 0) = 1.0 - shares(v, 1);
    inside += distance < 0.25 ? 1 : 0;
  }
  ASSERT_GT(inside, 3);
  const std::vector<int> labels = LabelFaces(mesh, shares, PlainPrices(mesh), {}, {});
  EXPECT_GT(std::count(labels.begin(), labels.end(), 1), 0);
  EXPECT_LT(std::count(labels.begin(), labels.end(), 1), 6 * inside);
}

TEST(FaceLabels, ExcludedSegmentsAreNotTakenWhereThereIsAnother)
{
  const TriangleMesh mesh = test::MakeCylinder(1.0, 6.0, 32, 60);
  std::vector<std::vector<int>> excluded(mesh.Triangles.size());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const double z = mesh.Centroid(t).z();
    // The boundary is walled in at 0.5; farther up both are ruled out, which says nothing.
    if (z > 0.0 && z < 0.5)
    {
      excluded[t] = { 1 };
    }
    else if (z > 2.0)
    {
      excluded[t] = { 0, 1 };
    }
  }
  const std::vector<int> labels =
    LabelFaces(mesh, TwoHalves(mesh), PlainPrices(mesh), excluded, {});
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_EQ(labels[t], mesh.Centroid(t).z() > 0.5 ? 1 : 0) << mesh.Centroid(t).z();
  }
}

TEST(LabelCleanUp, IslandsJoinTheNeighbourAlongTheLongestBorder)
{
  const test::Tube tube = test::MakeTube({});
  std::vector<int> pieces;
  for (std::size_t t = 0; t < tube.Fraction.size(); ++t)
  {
    const bool island = std::abs(tube.Fraction[t] - 0.25) < 0.05 && std::abs(tube.Angle[t]) < 0.4;
    pieces.push_back(tube.Fraction[t] < 0.5 && !island ? 0 : 1);
  }
  KeepLargestComponents(tube.Analyzed.Mesh, pieces);
  for (std::size_t t = 0; t < pieces.size(); ++t)
  {
    EXPECT_EQ(pieces[t], tube.Fraction[t] < 0.5 ? 0 : 1);
  }
}
