// SPDX-License-Identifier: BSD-3-Clause
#include "Skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

using namespace marrow;

namespace
{
Skeleton Make(int nodes, const std::vector<std::pair<int, int>>& edges)
{
  Skeleton skeleton;
  for (int i = 0; i < nodes; ++i)
  {
    SkeletonNode node;
    node.Position = Eigen::Vector3d(i, i % 2, 0.0);
    boost::add_vertex(node, skeleton.Graph);
  }
  for (const auto& [a, b] : edges)
  {
    boost::add_edge(a, b, skeleton.Graph);
  }
  skeleton.ExtractBranches();
  return skeleton;
}

std::vector<std::vector<int>> NodesOf(const Skeleton& skeleton)
{
  std::vector<std::vector<int>> nodes;
  for (const Branch& branch : skeleton.Branches)
  {
    nodes.push_back(branch.Nodes);
  }
  return nodes;
}

using Paths = std::vector<std::vector<int>>;
}

TEST(Skeleton, StarFallsIntoItsArms)
{
  // Junction 2 with the arms 0, 1 and 3-4.
  const Skeleton skeleton = Make(5, { { 0, 2 }, { 1, 2 }, { 2, 3 }, { 3, 4 } });
  EXPECT_EQ(NodesOf(skeleton), (Paths{ { 0, 2 }, { 1, 2 }, { 2, 3, 4 } }));
  EXPECT_EQ(skeleton.TypeOf(0), NodeType::Terminal);
  EXPECT_EQ(skeleton.TypeOf(2), NodeType::Junction);
  EXPECT_EQ(skeleton.TypeOf(3), NodeType::Regular);
  EXPECT_EQ(skeleton.NumberOfLoops(), 0);
  const auto ofNodes = skeleton.BranchesOfNodes();
  EXPECT_EQ(ofNodes[2], (std::vector<int>{ 0, 1, 2 }));
  EXPECT_TRUE(ofNodes[3].empty());
}

TEST(Skeleton, ArcLengthFollowsTheNodes)
{
  const Skeleton skeleton = Make(3, { { 0, 1 }, { 1, 2 } });
  ASSERT_EQ(skeleton.NumberOfBranches(), 1);
  const Branch& branch = skeleton.Branches[0];
  const double step = std::sqrt(2.0);
  EXPECT_DOUBLE_EQ(branch.ArcLength[1], step);
  EXPECT_DOUBLE_EQ(branch.Length(), 2.0 * step);
  EXPECT_DOUBLE_EQ(skeleton.TotalLength(), 2.0 * step);
}

TEST(Skeleton, LoopOnAJunctionIsOneBranchListedTwice)
{
  // A tail 0-1 and the loop 1-2-3-1.
  const Skeleton skeleton = Make(4, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 1 } });
  EXPECT_EQ(NodesOf(skeleton), (Paths{ { 0, 1 }, { 1, 2, 3, 1 } }));
  EXPECT_TRUE(skeleton.Branches[1].IsLoop());
  EXPECT_FALSE(skeleton.Branches[0].IsLoop());
  EXPECT_EQ(skeleton.NumberOfLoops(), 1);
  EXPECT_EQ(skeleton.BranchesOfNodes()[1], (std::vector<int>{ 0, 1, 1 }));
}

TEST(Skeleton, TwoLoopsOnOneJunction)
{
  const Skeleton skeleton = Make(5, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 3, 4 }, { 4, 0 } });
  EXPECT_EQ(NodesOf(skeleton), (Paths{ { 0, 1, 2, 0 }, { 0, 3, 4, 0 } }));
  EXPECT_EQ(skeleton.NumberOfLoops(), 2);
}

TEST(Skeleton, TwoBranchesBetweenTheSameJunctionsStayTwo)
{
  // Junctions 1 and 2 with an edge between them and the path 1-3-2; tails 0 and 4.
  const Skeleton skeleton = Make(5, { { 0, 1 }, { 1, 2 }, { 1, 3 }, { 3, 2 }, { 2, 4 } });
  EXPECT_EQ(NodesOf(skeleton), (Paths{ { 0, 1 }, { 1, 2 }, { 1, 3, 2 }, { 2, 4 } }));
}

TEST(Skeleton, IsolatedCycleIsOneBranchFromAPromotedNode)
{
  const Skeleton skeleton = Make(4, { { 1, 2 }, { 0, 3 }, { 3, 2 }, { 0, 1 } });
  EXPECT_EQ(NodesOf(skeleton), (Paths{ { 0, 1, 2, 3, 0 } }));
  EXPECT_TRUE(skeleton.Branches[0].IsLoop());
  EXPECT_EQ(skeleton.NumberOfLoops(), 1);
}

TEST(Skeleton, ComponentsAndIsolatedNodes)
{
  const Skeleton skeleton = Make(4, { { 0, 1 } });
  EXPECT_EQ(skeleton.NumberOfComponents(), 3);
  EXPECT_EQ(skeleton.NumberOfBranches(), 1);
  EXPECT_EQ(skeleton.TypeOf(3), NodeType::Isolated);
  EXPECT_EQ(Skeleton().NumberOfComponents(), 0);
  EXPECT_EQ(Skeleton().NumberOfLoops(), 0);
}

TEST(Skeleton, OrderOfEdgesDoesNotMatter)
{
  std::vector<std::pair<int, int>> edges{ { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 3, 4 },
    { 4, 0 }, { 4, 5 }, { 6, 7 }, { 7, 8 }, { 8, 6 } };
  const Paths expected = NodesOf(Make(9, edges));
  for (int turn = 0; turn < 5; ++turn)
  {
    std::rotate(edges.begin(), edges.begin() + 3, edges.end());
    std::swap(edges[1].first, edges[1].second);
    EXPECT_EQ(NodesOf(Make(9, edges)), expected);
  }
}
