// SPDX-License-Identifier: BSD-3-Clause
// Limbs that have grown onto the body are found as limbs.
#include "LoopOpening.h"
#include "MatchedShapes.h"

using namespace marrow;
using namespace marrow::test;

namespace
{
/// Somebody whose arms end at the hands or, if `onThighs`, on the thighs: a loop each.
SkeletonShape MakePerson(bool onThighs)
{
  SkeletonShape shape;
  shape.Point("chest", 0.0, 1.4, 0.0, 0.15);
  shape.Point("hip", 0.0, 1.0, 0.0, 0.14);
  shape.Point("neck", 0.0, 1.55, 0.0, 0.06);
  shape.Point("head", 0.02, 1.8, 0.0, 0.1);
  shape.Line({ "hip", "chest", "neck", "head" });
  for (const auto& [side, z] : { std::pair{ "left", 1.0 }, std::pair{ "right", -1.0 } })
  {
    const std::string s(side);
    shape.Point("elbow " + s, 0.05, 1.1, 0.35 * z, 0.05);
    shape.Point("thigh " + s, 0.0, 0.75, 0.15 * z, 0.09);
    shape.Point("foot " + s, 0.1, 0.0, 0.2 * z, 0.05);
    shape.Line({ "hip", "thigh " + s, "foot " + s });
    if (onThighs)
    {
      shape.Line({ "chest", "elbow " + s, "thigh " + s });
    }
    else
    {
      shape.Point("hand " + s, 0.1, 0.85, 0.35 * z, 0.03);
      shape.Line({ "chest", "elbow " + s, "hand " + s });
    }
  }
  return shape;
}

int NodeAt(const Skeleton& skeleton, const Eigen::Vector3d& position)
{
  for (int node = 0; node < skeleton.NumberOfNodes(); ++node)
  {
    if ((skeleton.Graph[node].Position - position).norm() < 1e-9)
    {
      return node;
    }
  }
  return -1;
}
}

TEST(LoopOpening, ABranchTakenOffItsJunctionHasATip)
{
  const SkeletonShape shape = MakePerson(true);
  const Skeleton given = shape.Build();
  ASSERT_EQ(2, given.NumberOfLoops());
  const int thigh = NodeAt(given, shape.Position("thigh left"));
  const int chest = NodeAt(given, shape.Position("chest"));
  const OpenedSkeleton unopened(given);
  bool found = false;
  for (const auto& end : unopened.OpenableEnds())
  {
    const Branch& branch = given.Branches[end.Branch];
    const int at = end.AtBack ? branch.Back() : branch.Front();
    const int other = end.AtBack ? branch.Front() : branch.Back();
    // Neither the neck nor the shins are on a loop.
    EXPECT_TRUE(
      given.TypeOf(at) == NodeType::Junction && given.TypeOf(other) == NodeType::Junction);
    if (at != thigh || other != chest)
    {
      continue;
    }
    found = true;
    const OpenedSkeleton opened = unopened.OpenedAt(end);
    EXPECT_EQ(1, opened.Opened.NumberOfLoops());
    // The arm has a tip outside the thigh, which stands for the junction.
    int tips = 0;
    for (int node = 0; node < given.NumberOfNodes(); ++node)
    {
      if (opened.Opened.TypeOf(node) == NodeType::Terminal &&
        given.TypeOf(node) != NodeType::Terminal)
      {
        ++tips;
        EXPECT_EQ(thigh, opened.GivenNode[node]);
        const double distance = (given.Graph[node].Position - given.Graph[thigh].Position).norm();
        EXPECT_GT(distance, given.Graph[thigh].Radius);
        EXPECT_LT(distance, 2.0 * given.Graph[thigh].Radius);
      }
      else
      {
        EXPECT_EQ(node, opened.GivenNode[node]);
      }
    }
    EXPECT_EQ(1, tips);
    // The leg is one branch of two parts, each told which way round it is gone through.
    int legs = 0;
    for (int b = 0; b < opened.Opened.NumberOfBranches(); ++b)
    {
      const auto parts = opened.PartsAlong(b, false);
      if (parts.size() != 2)
      {
        EXPECT_EQ(1u, parts.size());
        continue;
      }
      ++legs;
      const auto first = [&](const OpenedSkeleton::Part& part)
      {
        const Branch& of = given.Branches[part.Branch];
        return part.Reversed ? of.Back() : of.Front();
      };
      const auto last = [&](const OpenedSkeleton::Part& part)
      {
        const Branch& of = given.Branches[part.Branch];
        return part.Reversed ? of.Front() : of.Back();
      };
      EXPECT_EQ(opened.Opened.Branches[b].Front(), first(parts[0]));
      EXPECT_EQ(thigh, last(parts[0]));
      EXPECT_EQ(thigh, first(parts[1]));
      EXPECT_EQ(opened.Opened.Branches[b].Back(), last(parts[1]));
      const auto against = opened.PartsAlong(b, true);
      EXPECT_EQ(parts[0].Branch, against[1].Branch);
      EXPECT_NE(parts[0].Reversed, against[1].Reversed);
    }
    EXPECT_EQ(1, legs);
  }
  EXPECT_TRUE(found);
}

TEST(LoopOpening, HandsOnThighsAreHands)
{
  for (const bool sourceIsLooped : { false, true })
  {
    const Matched matched(MakePerson(sourceIsLooped), MakePerson(!sourceIsLooped), 3);
    ExpectConsistent(matched);
    matched.ExpectSame({ "head", "foot left", "foot right" });
    const int looped = sourceIsLooped ? 0 : 1;
    for (const std::string side : { "left", "right" })
    {
      const int arm = matched.BranchId(1 - looped, "chest", "hand " + side);
      EXPECT_GE(arm, 0);
      EXPECT_EQ(arm, matched.BranchId(looped, "chest", "thigh " + side));
      EXPECT_EQ(
        matched.NodeId(1 - looped, "hand " + side), matched.NodeId(looped, "thigh " + side));
      // The leg goes on past the hand.
      const int leg = matched.BranchId(1 - looped, "hip", "foot " + side);
      EXPECT_GE(leg, 0);
      EXPECT_EQ(leg, matched.BranchId(looped, "hip", "thigh " + side));
      EXPECT_EQ(leg, matched.BranchId(looped, "thigh " + side, "foot " + side));
    }
  }
}

TEST(LoopOpening, LoopsThatBothHaveStayClosed)
{
  const Matched matched(MakePerson(true), MakePerson(true), 5);
  matched.ExpectSame({ "head", "foot left", "foot right", "thigh left", "thigh right" });
}

TEST(LoopOpening, OnlyTheTreeWithGlobalSelectionOpensLoops)
{
  for (const auto selection : { Matched::Selection::Paper, Matched::Selection::Electors })
  {
    const Matched matched(MakePerson(false), MakePerson(true), 0, 0, selection);
    EXPECT_EQ(-1, matched.BranchId(1, "chest", "thigh left"));
  }
}
