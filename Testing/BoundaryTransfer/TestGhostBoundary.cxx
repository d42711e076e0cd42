// SPDX-License-Identifier: BSD-3-Clause
#include "GhostBoundary.h"
#include "TubeShapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace marrow;
using namespace marrow::test;

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

TEST(GhostBoundary, IsWhereTheGradientPeaks)
{
  TubeOptions options;
  options.Gradient = [](double f)
  { return 0.05 + std::exp(-0.5 * std::pow((f - 0.4) / 0.03, 2.0)); };
  const Tube tube = MakeTube(options);
  const Branch& branch = tube.Analyzed.Skeleton.Branches.front();
  const auto ghosts = FindGhostBoundaries(tube.Analyzed, branch, 1.5, 0.05);
  ASSERT_EQ(ghosts.size(), 1u);
  const bool forward = branch.Front() == 0;
  EXPECT_NEAR(forward ? ghosts[0].Ratio : 1.0 - ghosts[0].Ratio, 0.4, 0.03);
  // A gentle swell does not stand out by θ.
  options.Gradient = [](double f)
  { return 1.0 + 0.2 * std::exp(-0.5 * std::pow((f - 0.4) / 0.03, 2.0)); };
  EXPECT_TRUE(FindGhostBoundaries(MakeTube(options).Analyzed, branch, 1.5, 0.05).empty());
}
