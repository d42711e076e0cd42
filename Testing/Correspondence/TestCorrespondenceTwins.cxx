// SPDX-License-Identifier: BSD-3-Clause
// One limb against a pair of twins: a head without horns against a skull that ends in two horns.
#include "MatchedShapes.h"

#include "LeafSelection.h"

#include <gtest/gtest.h>

#include <string>

using namespace marrow::test;

namespace
{
/// A quadruped whose head carries two alike horns in place of a tip.
SkeletonShape MakeHorned()
{
  SkeletonShape shape = MakeQuadruped();
  for (const auto& [name, z] : { std::pair{ "horn left", 0.3 }, std::pair{ "horn right", -0.3 } })
  {
    shape.Point(name, 2.05, 1.8, z, 0.04);
    shape.Line({ "head", name });
  }
  return shape;
}

int FeatureAt(const marrow::FeatureGraph& graph, const Eigen::Vector3d& position)
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

/// The head goes on to a snout, and there is a small ear at it: no twins.
SkeletonShape MakeEared()
{
  SkeletonShape shape = MakeQuadruped();
  shape.Point("snout", 2.5, 1.35, 0.0, 0.1);
  shape.Point("ear", 1.85, 1.7, 0.1, 0.02);
  shape.Line({ "head", "snout" });
  shape.Line({ "head", "ear" });
  return shape;
}
}

TEST(CorrespondenceTwins, OneLimbIsMatchedWithWhatCarriesAPair)
{
  // The pair on the target, and on the source. Without leaves of the tree, so that the rule is seen alone.
  for (const bool sourceHorned : { false, true })
  {
    const SkeletonShape shapes[] = { sourceHorned ? MakeHorned() : MakeQuadruped(),
      sourceHorned ? MakeQuadruped() : MakeHorned() };
    const marrow::Skeleton skeletons[] = { shapes[0].Build(), shapes[1].Build() };
    const marrow::FeatureGraph source(skeletons[0], 8);
    const marrow::FeatureGraph target(skeletons[1], 8);
    const std::vector<marrow::RatedLeaf> leaves = marrow::RateLeaves(source, target, {}, true);
    ASSERT_FALSE(leaves.empty());
    const marrow::FeatureCorrespondence& match = leaves.front().Match;
    const int sourceHead = FeatureAt(source, shapes[0].Position("head"));
    const int targetHead = FeatureAt(target, shapes[1].Position("head"));
    const marrow::FeatureGraph& horned = sourceHorned ? source : target;
    bool found = false;
    for (const marrow::MatchedNodes& nodes : match.Nodes)
    {
      if (nodes.Source.Contains(sourceHead))
      {
        found = true;
        EXPECT_TRUE(nodes.Target.Contains(targetHead));
      }
      for (const char* horn : { "horn left", "horn right" })
      {
        const SkeletonShape& shape = shapes[sourceHorned ? 0 : 1];
        const marrow::FeatureGroup& group = sourceHorned ? nodes.Source : nodes.Target;
        EXPECT_FALSE(group.Contains(FeatureAt(horned, shape.Position(horn)))) << horn;
      }
    }
    EXPECT_TRUE(found);
    // The branch ends where the pair begins, on both.
    EXPECT_TRUE(std::any_of(match.Branches.begin(), match.Branches.end(),
      [&](const marrow::MatchedBranches& branches)
      {
        const auto ends =
          [](const marrow::FeatureGraph& graph, const std::vector<int>& path, int head)
        { return graph.Head(path.back()) == head || graph.Origin(path.front()) == head; };
        return ends(source, branches.Source, sourceHead) &&
          ends(target, branches.Target, targetHead);
      }));
  }
}

TEST(CorrespondenceTwins, APairIsMatchedWithAPair)
{
  SkeletonShape target = MakeHorned();
  target.Move("horn left", 0.1, 0.1, 0.1);
  target.Move("horn right", 0.1, 0.1, -0.1);
  const Matched matched(MakeHorned(), target);
  matched.ExpectSame({ "head", "horn left", "horn right" });
}

TEST(CorrespondenceTwins, ATipBesideSomethingElseStaysATip)
{
  SkeletonShape source = MakeQuadruped();
  source.Move("head", 0.5, 0.0, 0.0);
  const Matched matched(source, MakeEared());
  EXPECT_GE(matched.NodeId(0, "head"), 0);
  EXPECT_EQ(matched.NodeId(0, "head"), matched.NodeId(1, "snout"));
  EXPECT_EQ(-1, matched.NodeId(1, "ear"));
}
