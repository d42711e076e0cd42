// SPDX-License-Identifier: BSD-3-Clause
#include "ChainAlignment.h"
#include "TubeShapes.h"

#include <gtest/gtest.h>

using namespace marrow;
using namespace marrow::test;

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
