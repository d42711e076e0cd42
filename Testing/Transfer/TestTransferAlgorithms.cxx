// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryTransfer.h"
#include "ChainAlignment.h"
#include "CylinderMap.h"
#include "GhostBoundary.h"
#include "LabelCleanUp.h"
#include "LabelCut.h"
#include "MeshSmoother.h"
#include "MinimumCut.h"
#include "SegmentLoops.h"
#include "TubeShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace marrow;
using namespace marrow::test;

TEST(MinimumCut, CutsTheCheapestEdge)
{
  MinimumCut cut(4);
  cut.AddTerminal(0, 10.0, 0.0);
  cut.AddTerminal(3, 0.0, 10.0);
  cut.AddEdge(0, 1, 3.0, 3.0);
  cut.AddEdge(1, 2, 1.0, 1.0);
  cut.AddEdge(2, 3, 2.0, 2.0);
  EXPECT_EQ(cut.Solve(), (std::vector<bool>{ true, true, false, false }));
}

TEST(MinimumCut, DirectedCapacitiesCountOneWay)
{
  MinimumCut cut(2);
  cut.AddTerminal(0, 5.0, 0.0);
  cut.AddTerminal(1, 0.0, 5.0);
  cut.AddEdge(0, 1, 0.0, 100.0);
  EXPECT_EQ(cut.Solve(), (std::vector<bool>{ true, false }));
}

TEST(LabelCut, MatchesExhaustiveSearchOnAChain)
{
  // Three labels on six sites; expansion is exact on what this small problem has.
  LabelProblem problem;
  problem.NumberOfLabels = 3;
  const double costs[6][3] = { { 0, 2, 3 }, { 1, 0.6, 2 }, { 2, 0, 1 }, { 2, 0.5, 0.4 },
    { 3, 2, 0 }, { 0.2, 2, 0.5 } };
  for (const auto& row : costs)
  {
    problem.Costs.push_back({ { 0, row[0] }, { 1, row[1] }, { 2, row[2] } });
  }
  for (int i = 0; i < 5; ++i)
  {
    problem.Edges.push_back({ i, i + 1, 0.7 });
  }
  const auto energy = [&](const std::vector<int>& labels)
  {
    double sum = 0.0;
    for (int i = 0; i < 6; ++i)
    {
      sum += costs[i][labels[i]] + (i > 0 && labels[i] != labels[i - 1] ? 0.7 : 0.0);
    }
    return sum;
  };
  double least = 1e9;
  for (int code = 0; code < 729; ++code)
  {
    std::vector<int> labels;
    for (int rest = code, i = 0; i < 6; ++i, rest /= 3)
    {
      labels.push_back(rest % 3);
    }
    least = std::min(least, energy(labels));
  }
  EXPECT_NEAR(energy(SolveLabels(problem, {})), least, 1e-12);
}

TEST(LabelCut, SitesKeepToTheirLists)
{
  LabelProblem problem;
  problem.NumberOfLabels = 2;
  problem.Costs = { { { 0, 0.0 } }, { { 0, 5.0 }, { 1, 5.1 } }, { { 1, 9.0 } } };
  problem.Edges = { { 0, 1, 1.0 }, { 1, 2, 10.0 } };
  EXPECT_EQ(SolveLabels(problem, {}), (std::vector<int>{ 0, 1, 1 }));
}

TEST(SegmentLoops, ThreeBandsHaveTwoLoops)
{
  const Tube tube = MakeTube({});
  std::vector<int> labels;
  for (double f : tube.Fraction)
  {
    labels.push_back(f < 0.3 ? 5 : (f < 0.6 ? -2 : 5));
  }
  const SegmentPieces pieces = FindPieces(tube.Analyzed.Mesh, labels);
  EXPECT_EQ(pieces.NumberOfPieces(), 3); // the two ends are pieces of one segment
  const auto loops = FindLoops(tube.Analyzed.Mesh, pieces);
  ASSERT_EQ(loops.size(), 2u);
  for (const SegmentLoop& loop : loops)
  {
    EXPECT_NE(pieces.LabelOfPiece[loop.LeftPiece], pieces.LabelOfPiece[loop.RightPiece]);
    for (std::size_t i = 0; i < loop.HalfEdges.size(); ++i)
    {
      const int h = loop.HalfEdges[i];
      EXPECT_EQ(tube.Analyzed.Mesh.To(h),
        tube.Analyzed.Mesh.From(loop.HalfEdges[(i + 1) % loop.HalfEdges.size()]));
      EXPECT_EQ(pieces.PieceOfTriangle[TriangleMesh::TriangleOf(h)], loop.LeftPiece);
    }
  }
}

TEST(SegmentLoops, ThreeWayJunctionsGiveClosedLoopsOnce)
{
  // Two halves of the tube's lower part and its upper part meet in two junction vertices.
  const Tube tube = MakeTube({});
  std::vector<int> labels;
  for (std::size_t t = 0; t < tube.Fraction.size(); ++t)
  {
    labels.push_back(tube.Fraction[t] > 0.5 ? 0 : (tube.Angle[t] > 0.0 ? 1 : 2));
  }
  const SegmentPieces pieces = FindPieces(tube.Analyzed.Mesh, labels);
  ASSERT_EQ(pieces.NumberOfPieces(), 3);
  const auto loops = FindLoops(tube.Analyzed.Mesh, pieces);
  // Two of the three border loops cover every edge; the third would say nothing new.
  EXPECT_EQ(loops.size(), 2u);
}

TEST(LabelCleanUp, IslandsJoinTheNeighbourAlongTheLongestBorder)
{
  const Tube tube = MakeTube({});
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

TEST(MeshSmoother, KeepsConstantsSumsAndBounds)
{
  const Tube tube = MakeTube({});
  const TriangleMesh& mesh = tube.Analyzed.Mesh;
  Eigen::MatrixXd values(mesh.NumberOfVertices(), 2);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    values(v, 0) = mesh.Points[v].z() > 0.0 ? 1.0 : 0.0;
    values(v, 1) = 1.0 - values(v, 0);
  }
  const Eigen::MatrixXd smooth = MeshSmoother(mesh, 0.2).Smooth(values);
  EXPECT_LT((smooth.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-9);
  EXPECT_GE(smooth.minCoeff(), -1e-12);
  // exp(-x / width) beyond the step, on a fine enough mesh.
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (std::abs(mesh.Points[v].z() + 0.4) < 1e-9)
    {
      EXPECT_NEAR(smooth(v, 0), 0.5 * std::exp(-0.4 / 0.2), 0.03);
    }
  }
}

TEST(CylinderMap, IsHeightAndAngleOnACylinder)
{
  const Tube tube = MakeTube({});
  const TriangleMesh& mesh = tube.Analyzed.Mesh;
  PathFinder paths(mesh);
  FittingPlane plane;
  plane.Normal = Eigen::Vector3d::UnitZ();
  plane.Radius = 0.5;
  std::vector<Eigen::Vector3d> rays;
  for (int k = 0; k < 16; ++k)
  {
    rays.push_back(0.5 * Eigen::Vector3d(std::cos(k * Pi / 8.0), std::sin(k * Pi / 8.0), 0.0));
  }
  auto region =
    BuildCoveringRegion(mesh, paths, plane, SeedsOfRays(mesh, plane.Center, rays), 0.5, {});
  ASSERT_TRUE(region);
  const auto map = CylinderMap::Build(paths, mesh, *region, plane.Center, plane.Normal);
  ASSERT_TRUE(map);
  double low = 1e9;
  double high = -1e9;
  for (int v : region->Rims[0])
  {
    low = std::min(low, mesh.Points[v].z());
    EXPECT_EQ(map->OfVertex(v).y(), 0.0);
  }
  for (int v : region->Rims[1])
  {
    high = std::max(high, mesh.Points[v].z());
  }
  ASSERT_LT(low, -0.4);
  ASSERT_GT(high, 0.4);
  double offset = 2.0;
  std::set<int> vertices;
  for (int t : region->Triangles)
  {
    vertices.insert(mesh.Triangles[t].begin(), mesh.Triangles[t].end());
  }
  for (int v : vertices)
  {
    const Eigen::Vector3d& p = mesh.Points[v];
    const Eigen::Vector2d uv = map->OfVertex(v);
    EXPECT_NEAR(uv.y(), (p.z() - low) / (high - low), 0.02);
    double difference = uv.x() - std::atan2(p.y(), p.x()) / (2.0 * Pi);
    difference -= std::floor(difference);
    offset = offset > 1.0 ? difference : offset;
    double change = difference - offset;
    change -= std::round(change);
    EXPECT_NEAR(change, 0.0, 0.01);
    // There and back.
    EXPECT_LT((map->PointAt(uv) - p).norm(), 1e-6);
  }
  // A curve at v = 1/2 parts the region's triangles by height.
  std::vector<Eigen::Vector2d> curve;
  for (int k = 0; k < 50; ++k)
  {
    curve.push_back({ k / 50.0, 0.5 });
  }
  for (const auto& [triangle, side] : SidesOfCurve(*map, curve))
  {
    const double z = mesh.Centroid(triangle).z() - 0.5 * (low + high);
    if (std::abs(z) > 0.02)
    {
      EXPECT_EQ(side, z > 0.0 ? 1 : 0);
    }
  }
}

TEST(GhostBoundary, BestPairIsALandmark)
{
  const auto landmark =
    MatchGhostBoundaries({ { 0.3, 0.5 }, { 0.7, 0.5 } }, { { 0.66, 0.45 }, { 0.1, 0.9 } });
  ASSERT_TRUE(landmark);
  EXPECT_EQ(landmark->Source, 0.7);
  EXPECT_EQ(landmark->Target, 0.66);
  // Landmarks a third of the branch apart are none.
  EXPECT_FALSE(MatchGhostBoundaries({ { 0.3, 0.5 } }, { { 0.6, 0.5 } }));
  EXPECT_FALSE(MatchGhostBoundaries({}, { { 0.6, 0.5 } }));
}

TEST(ChainAlignment, IsLinearBetweenKnotsBothWays)
{
  const ChainAlignment equal;
  EXPECT_DOUBLE_EQ(equal.TargetRatio(0.37), 0.37);
  const ChainAlignment alignment({ { 0.0, 0.0 }, { 0.4, 0.5 }, { 1.0, 1.0 } });
  EXPECT_DOUBLE_EQ(alignment.TargetRatio(0.4), 0.5);
  EXPECT_DOUBLE_EQ(alignment.TargetRatio(0.2), 0.25);
  EXPECT_DOUBLE_EQ(alignment.TargetRatio(0.7), 0.75);
  EXPECT_DOUBLE_EQ(alignment.SourceRatio(alignment.TargetRatio(0.9)), 0.9);
  EXPECT_DOUBLE_EQ(alignment.TargetRatio(1.0), 1.0);
}

TEST(ChainAlignment, FollowsAStepOfThickness)
{
  // Thick up to 0.5 of the source and up to 0.6 of the target.
  Tube source = MakeTube({});
  Tube target = MakeTube({});
  const auto thicken = [](Tube& tube, double upTo)
  {
    const int n = tube.Analyzed.Skeleton.NumberOfNodes();
    for (int node = 0; node < n; ++node)
    {
      tube.Analyzed.Skeleton.Graph[node].MSP *= node < upTo * (n - 1) ? 2.0 : 1.0;
    }
  };
  thicken(source, 0.5);
  thicken(target, 0.6);
  const MatchedSkeletons match = MatchTubes(source, target);
  const ChainPair& chain = match.Chains[0];
  const ChainAlignment alignment =
    AlignChains(source.Analyzed, chain.Source, target.Analyzed, chain.Target, {});
  const bool forward = chain.Source.Front() == 0;
  EXPECT_NEAR(alignment.TargetRatio(0.5), forward ? 0.6 : 0.4, 0.03);
  // Alike chains stay as they are.
  EXPECT_NEAR(
    AlignChains(source.Analyzed, chain.Source, source.Analyzed, chain.Source, {}).TargetRatio(0.3),
    0.3, 1e-9);
}

TEST(MatchedSkeletons, BranchesOfOneIdBecomeOneChain)
{
  // A path of three branches on the source (with a spur at each joint) and one on the target.
  Skeleton source;
  source.Graph = SkeletonGraph(6);
  const double x[6] = { 0, 1, 2, 4, 1, 2 };
  for (int n = 0; n < 6; ++n)
  {
    source.Graph[n].Position = { x[n], n >= 4 ? 1.0 : 0.0, 0.0 };
    source.Graph[n].AGD = n == 3 ? 1.0 : 0.2;
  }
  for (auto [a, b] : { std::pair{ 0, 1 }, { 1, 2 }, { 2, 3 }, { 1, 4 }, { 2, 5 } })
  {
    boost::add_edge(a, b, source.Graph);
  }
  source.ExtractBranches();
  Skeleton target;
  target.Graph = SkeletonGraph(2);
  target.Graph[0].Position = { 7, 0, 0 };
  target.Graph[0].AGD = 1.0;
  target.Graph[1].AGD = 0.2;
  boost::add_edge(0, 1, target.Graph);
  target.ExtractBranches();

  CorrespondenceIds ids;
  ids.SourceNodes.assign(6, -1);
  ids.TargetNodes.assign(2, -1);
  ids.TargetBranches = { 4 };
  for (const Branch& branch : source.Branches)
  {
    const bool onPath = branch.Front() < 4 && branch.Back() < 4;
    ids.SourceBranches.push_back(onPath ? 4 : -1);
  }
  const MatchedSkeletons match = JoinChains(source, target, ids);
  ASSERT_EQ(match.Chains.size(), 1u);
  const ChainPair& pair = match.Chains[0];
  EXPECT_DOUBLE_EQ(pair.Source.Length(), 4.0);
  ASSERT_EQ(pair.Source.Nodes.size(), 4u);
  // The ends of like AGD lie together: 3 with 0.
  EXPECT_EQ(pair.Source.Front() == 3, pair.Target.Front() == 0);
  EXPECT_TRUE((PointOnChain(source, pair.Source, 0.5) - Eigen::Vector3d(2, 0, 0)).norm() < 1e-12);
}
