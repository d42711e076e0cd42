// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonShapes.h"

#include "BeamSearch.h"
#include "BranchAssignment.h"
#include "BranchClusters.h"
#include "CorrespondenceTree.h"
#include "GlobalCost.h"
#include "JunctionCost.h"
#include "SplitConsensus.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

using namespace marrow;
using namespace marrow::test;

namespace
{
constexpr int Pieces = 8;

/// The feature at a named point.
int FeatureAt(const FeatureGraph& graph, const Eigen::Vector3d& position)
{
  for (int f = 0; f < graph.NumberOfFeatures(); ++f)
  {
    if ((graph.GetFeatures()[f].Position - position).norm() < 1e-9)
    {
      return f;
    }
  }
  return -1;
}

FeatureGroup Group(int feature)
{
  return FeatureGroup{ { feature }, {} };
}

/// A cross of four arms, a loop at its centre, and a triangle of branches at the end of one arm.
SkeletonShape MakeKnot()
{
  SkeletonShape shape;
  shape.Point("center", 0.0, 0.0, 0.0, 0.1);
  shape.Point("east", 2.0, 0.0, 0.0, 0.1);
  shape.Point("west", -1.0, 0.0, 0.0, 0.1);
  shape.Point("tip", 5.0, 0.0, 0.0, 0.1);
  shape.Point("upper", 2.5, 1.0, 0.0, 0.1);
  shape.Point("ring a", 0.5, -1.0, 0.0, 0.1);
  shape.Point("ring b", -0.5, -1.0, 0.0, 0.1);
  shape.Line({ "center", "west" });
  shape.Line({ "center", "east" });
  shape.Line({ "center", "upper" });
  shape.Line({ "east", "upper" });
  shape.Line({ "east", "tip" });
  shape.Line({ "center", "ring a", "ring b", "center" });
  return shape;
}
}

TEST(CorrespondenceAlgorithms, SubSkeletonsShareALoop)
{
  const Skeleton skeleton = MakeKnot().Build();
  const FeatureGraph graph(skeleton, Pieces);
  const FeatureGroup center = Group(FeatureAt(graph, Eigen::Vector3d::Zero()));
  const std::vector<int> darts = graph.OpenDarts(center);
  // "upper" is a regular node, so centre and east are joined by two branches.
  ASSERT_EQ(5u, darts.size());
  const std::vector<double> sizes = graph.SubSkeletonSizes(center, darts);
  EXPECT_NEAR(1.0, std::accumulate(sizes.begin(), sizes.end(), 0.0), 1e-12);
  const double total = skeleton.TotalLength();
  for (std::size_t i = 0; i < darts.size(); ++i)
  {
    const int head = graph.Head(darts[i]);
    const Eigen::Vector3d end = graph.GetFeatures()[head].Position;
    if (end.x() < -0.9)
    {
      EXPECT_NEAR(1.0 / total, sizes[i], 0.02);
    }
    else if (head == center.Features[0])
    {
      // Each end of the ring has half of it.
      EXPECT_NEAR(0.5 * graph.Length(darts[i] / 2), sizes[i], 1e-12);
    }
    else
    {
      // Two ways to the same part: both lengths and the arm, halved.
      EXPECT_NEAR(
        0.5 * (2.0 + 3.0 + std::hypot(2.5, 1.0) + std::hypot(0.5, 1.0)) / total, sizes[i], 0.02);
    }
  }
}

TEST(CorrespondenceAlgorithms, StructureCostFollowsThePaper)
{
  EXPECT_DOUBLE_EQ(0.0, StructureCost({ 0.2, 0.5, 0.3 }, { 0.5, 0.3, 0.2 }));
  // Sorted: (0.5, 0.3, 0.2) against (0.6, 0.4): 0.01 + 0.01 + 0.04, whichever comes first.
  EXPECT_NEAR(0.06, StructureCost({ 0.3, 0.2, 0.5 }, { 0.4, 0.6 }), 1e-12);
  EXPECT_NEAR(0.06, StructureCost({ 0.4, 0.6 }, { 0.3, 0.2, 0.5 }), 1e-12);
}

TEST(CorrespondenceAlgorithms, ProfilesAreMeansAlongThePath)
{
  SkeletonShape shape;
  shape.Point("a", 0.0, 0.0, 0.0, 0.0);
  shape.Point("b", 1.0, 0.0, 0.0, 1.0);
  shape.Line({ "a", "b" });
  const Skeleton skeleton = shape.Build();
  const FeatureGraph graph(skeleton, Pieces);
  const bool fromA = graph.GetFeatures()[graph.Origin(0)].MSP < 0.5;
  const std::vector<double> profile =
    graph.Profile({ fromA ? 0 : 1 }, FeatureGraph::Measure::MSP, 5);
  for (int k = 0; k < 5; ++k)
  {
    EXPECT_NEAR(0.2 * k + 0.1, profile[k], 1e-12);
  }
  EXPECT_NEAR(0.25, graph.PointAt({ fromA ? 0 : 1 }, 0.25).x(), 1e-12);
}

TEST(CorrespondenceAlgorithms, ClustersHoldWhatIsAlike)
{
  const Skeleton skeleton = MakeQuadruped().Build();
  const FeatureGraph graph(skeleton, Pieces);
  const FeatureGroup hip = Group(FeatureAt(graph, Eigen::Vector3d(0.0, 1.05, 0.0)));
  const std::vector<int> darts = graph.OpenDarts(hip);
  const std::vector<int> clusters = ClusterBranches(graph, darts, 0.1);
  EXPECT_EQ(1, NumberOfClusters(clusters));
  for (std::size_t i = 0; i < darts.size(); ++i)
  {
    const bool leg = graph.GetFeatures()[graph.Head(darts[i])].Position.y() < 0.0;
    EXPECT_EQ(leg ? 0 : -1, clusters[i]);
  }
  EXPECT_EQ(0, NumberOfClusters(ClusterBranches(graph, darts, 0.0)) - 1);
  const std::vector<int> all = ClusterBranches(graph, darts, 10.0);
  EXPECT_EQ(0, *std::max_element(all.begin(), all.end()));
}

TEST(CorrespondenceAlgorithms, RotationsAreNeverReflections)
{
  const std::vector<Eigen::Vector3d> axes{ Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
    Eigen::Vector3d::UnitZ() };
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.2, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  std::vector<Eigen::Vector3d> turned;
  std::vector<Eigen::Vector3d> mirrored;
  for (const Eigen::Vector3d& axis : axes)
  {
    turned.push_back(turn * axis);
    mirrored.push_back(-axis);
  }
  Eigen::Matrix3d rotation;
  EXPECT_TRUE(BestRotation(turned, axes, rotation));
  EXPECT_LT((rotation - turn).norm(), 1e-12);
  EXPECT_NEAR(0.0, SpatialCost(turned, axes), 1e-12);
  EXPECT_FALSE(BestRotation(mirrored, axes, rotation));
  EXPECT_NEAR(1.0, rotation.determinant(), 1e-12);
  // What lies in a plane can be turned over.
  const std::vector<Eigen::Vector3d> flat{ Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
    -Eigen::Vector3d::UnitX() };
  const std::vector<Eigen::Vector3d> over{ Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitY(),
    -Eigen::Vector3d::UnitX() };
  EXPECT_TRUE(BestRotation(flat, over, rotation));
}

TEST(CorrespondenceAlgorithms, FindsTheTurnedAssignmentAmongMany)
{
  // Five are enumerated, nine are found by rotations.
  for (const int count : { 5, 9 })
  {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    BranchSets sets;
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.0, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()).toRotationMatrix();
    for (int i = 0; i < count; ++i)
    {
      const Eigen::Vector3d p =
        Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
      sets.Source.push_back(p);
      sets.Target.push_back(turn * p);
    }
    std::rotate(sets.Target.begin(), sets.Target.begin() + 2, sets.Target.end());
    sets.Unlikeness = Eigen::MatrixXd::Zero(count, count);
    std::vector<BranchAssignment> assignments = FindAssignments(sets);
    ASSERT_FALSE(assignments.empty());
    // One per pair on a pair at most: the work stays polynomial where there are 9! assignments.
    EXPECT_LE(static_cast<int>(assignments.size()), count * count * count * count);
    const auto best = std::min_element(assignments.begin(), assignments.end(),
      [](const BranchAssignment& a, const BranchAssignment& b)
      { return a.SpatialCost < b.SpatialCost; });
    EXPECT_NEAR(0.0, best->SpatialCost, 1e-9);
    for (int i = 0; i < count; ++i)
    {
      EXPECT_EQ((i + count - 2) % count, best->TargetOfSource[i]);
    }
  }
}

TEST(CorrespondenceAlgorithms, GlobalCostIsLeastForTheSame)
{
  const Skeleton skeleton = MakeQuadruped().Build();
  const FeatureGraph graph(skeleton, Pieces);
  const TerminalPaths paths(graph);
  ASSERT_EQ(6, paths.Size());
  const GlobalCost cost(paths, paths, {});
  GlobalCost::Assignment same(6);
  std::iota(same.begin(), same.end(), 0);
  EXPECT_NEAR(0.0, cost.Total(same), 1e-9);
  for (int i = 0; i < 6; ++i)
  {
    GlobalCost::Assignment dropped = same;
    dropped[i] = -1;
    EXPECT_GT(cost.Total(dropped), 0.01);
    for (int k = i + 1; k < 6; ++k)
    {
      GlobalCost::Assignment exchanged = same;
      std::swap(exchanged[i], exchanged[k]);
      EXPECT_GT(cost.Total(exchanged), 1e-4) << i << " with " << k;
    }
  }
}

TEST(CorrespondenceAlgorithms, AHintThatIsKeptCostsNothingWhateverTheProportions)
{
  const Skeleton skeleton = MakeQuadruped().Build();
  const FeatureGraph graph(skeleton, Pieces);
  const TerminalPaths paths(graph);
  const int tip = graph.GetFeatures()[paths.Feature(0)].Node;
  const auto branch = std::find_if(skeleton.Branches.begin(), skeleton.Branches.end(),
    [&](const Branch& some) { return some.Front() == tip || some.Back() == tip; });
  ASSERT_NE(branch, skeleton.Branches.end());
  // Far from the tip, yet on the same branch.
  const int next =
    branch->Front() == tip ? branch->Nodes[branch->Nodes.size() - 2] : branch->Nodes[1];
  ASSERT_NE(next, tip);
  const HintCost cost(paths, paths, { { tip, next, false } });
  GlobalCost::Assignment assignment(paths.Size());
  std::iota(assignment.begin(), assignment.end(), 0);
  EXPECT_EQ(0.0, cost.Total(assignment));
  std::swap(assignment[0], assignment[1]);
  EXPECT_GT(cost.Total(assignment), 0.0);
  assignment[1] = -1;
  assignment[0] = -1;
  EXPECT_GE(cost.Total(assignment), HintCost::Weight) << "neither branch is matched";
}

TEST(CorrespondenceAlgorithms, OthersAreCheapAndUnlikeWhatIsKnown)
{
  const Skeleton skeleton = MakeQuadruped().Build();
  const FeatureGraph graph(skeleton, Pieces);
  const TerminalPaths paths(graph);
  const GlobalCost cost(paths, paths, {});
  GlobalCost::Assignment same(paths.Size());
  std::iota(same.begin(), same.end(), 0);
  const std::vector<GlobalCost::Assignment> found = FindOthers(cost, paths, paths, {});
  ASSERT_GT(found.size(), 1u);
  EXPECT_EQ(same, found.front()) << "the cheapest of all";

  std::vector<GlobalCost::Assignment> known{ same };
  for (const GlobalCost::Assignment& other : FindOthers(cost, paths, paths, known))
  {
    EXPECT_GE(cost.Total(other), cost.Total(known.back())) << "the cheapest first";
    std::vector<bool> isTaken(paths.Size(), false);
    for (const int target : other)
    {
      if (target >= 0)
      {
        EXPECT_FALSE(isTaken[target]) << "matched twice";
        isTaken[target] = true;
      }
    }
    for (const GlobalCost::Assignment& before : known)
    {
      double difference = 0.0;
      for (int i = 0; i < paths.Size(); ++i)
      {
        difference += other[i] != before[i] ? paths.Weight(i) : 0.0;
      }
      EXPECT_GE(difference, 0.25);
    }
    known.push_back(other);
  }
  EXPECT_GT(known.size(), 1u);
}

TEST(CorrespondenceAlgorithms, SplitsGiveBranches)
{
  // In the target the spine is missing: all six branches meet in one junction.
  const SkeletonShape quadruped = MakeQuadruped();
  SkeletonShape star = quadruped;
  star.Move("chest", -0.5, 0.0, 0.0);
  star.Move("hip", 0.5, -0.05, 0.0);
  const Skeleton source = quadruped.Build();
  const Skeleton target = star.Build();
  const FeatureGraph sourceGraph(source, Pieces);
  const FeatureGraph targetGraph(target, Pieces);
  const TerminalPaths sourcePaths(sourceGraph);
  const TerminalPaths targetPaths(targetGraph);
  GlobalCost::Assignment targetOf(sourcePaths.Size(), -1);
  for (int i = 0; i < sourcePaths.Size(); ++i)
  {
    const Eigen::Vector3d p = sourceGraph.GetFeatures()[sourcePaths.Feature(i)].Position;
    targetOf[i] = targetPaths.TerminalAt(FeatureAt(targetGraph, p));
    ASSERT_GE(targetOf[i], 0);
  }
  const FeatureCorrespondence all = MatchBySplits(sourcePaths, targetPaths, targetOf);
  EXPECT_EQ(7u, all.Branches.size());
  EXPECT_EQ(8u, all.Nodes.size());
  // A swap of a fore with a hind leg contradicts the spine: it is contracted on both sides.
  int fore = -1;
  int hind = -1;
  for (int i = 0; i < sourcePaths.Size(); ++i)
  {
    const Eigen::Vector3d p = sourceGraph.GetFeatures()[sourcePaths.Feature(i)].Position;
    fore = std::abs(p.x() - 1.0) < 1e-9 && p.z() > 0.0 ? i : fore;
    hind = std::abs(p.x() + 0.15) < 1e-9 && p.z() > 0.0 ? i : hind;
  }
  ASSERT_GE(fore, 0);
  ASSERT_GE(hind, 0);
  std::swap(targetOf[fore], targetOf[hind]);
  const FeatureCorrespondence contracted = MatchBySplits(sourcePaths, targetPaths, targetOf);
  EXPECT_EQ(6u, contracted.Branches.size());
  EXPECT_EQ(7u, contracted.Nodes.size());
  EXPECT_EQ(2, contracted.Merges);
  const auto merged = std::max_element(contracted.Nodes.begin(), contracted.Nodes.end(),
    [](const MatchedNodes& a, const MatchedNodes& b)
    { return a.Source.Features.size() < b.Source.Features.size(); });
  EXPECT_EQ(2u, merged->Source.Features.size());
  EXPECT_EQ(1u, merged->Source.Inside.size());
  for (const MatchedBranches& branches : contracted.Branches)
  {
    EXPECT_EQ(static_cast<int>(merged - contracted.Nodes.begin()), branches.First);
  }
}

TEST(CorrespondenceAlgorithms, GrowthCanBeStopped)
{
  const Skeleton skeleton = MakeQuadruped().Build();
  const FeatureGraph graph(skeleton, Pieces);
  CorrespondenceTree tree(graph, graph, TreeParameters());
  EXPECT_FALSE(tree.Grow([](double) { return false; }));
  double last = -1.0;
  CorrespondenceTree whole(graph, graph, TreeParameters());
  EXPECT_TRUE(whole.Grow(
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1.0);
      last = fraction;
      return true;
    }));
}
