// SPDX-License-Identifier: BSD-3-Clause
// Boundaries on tubes go to places that are known.
#include "SegmentationTransfer.h"
#include "TubeShapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// Label 0 where `height` (a fraction of the length by the angle) is above the triangle, else 1.
std::vector<int> CutTube(const Tube& tube, const std::function<double(double)>& height)
{
  std::vector<int> labels;
  for (std::size_t t = 0; t < tube.Fraction.size(); ++t)
  {
    labels.push_back(tube.Fraction[t] < height(tube.Angle[t]) ? 0 : 1);
  }
  return labels;
}

TransferResult Transfer(const Tube& source, const Tube& target, const std::vector<int>& labels,
  bool strictBoundaries = false)
{
  TransferParameters parameters;
  parameters.StrictBoundaries = strictBoundaries;
  return TransferSegmentation(source.Analyzed, target.Analyzed,
    { { MatchTubes(source, target), 0.0, 1.0, 0.0 } }, labels, parameters, {}, {});
}

/// The share of triangles whose label is what `height` says.
double Agreement(
  const Tube& tube, const TransferResult& result, const std::function<double(double)>& height)
{
  const std::vector<int> expected = CutTube(tube, height);
  double same = 0.0;
  for (std::size_t t = 0; t < expected.size(); ++t)
  {
    same += expected[t] == result.Labels[t] ? 1.0 : 0.0;
  }
  return same / expected.size();
}

TubeOptions LongAndThick()
{
  TubeOptions options;
  options.Radius = 0.9;
  options.Length = 8.0;
  options.Around = 40;
  options.Along = 64;
  return options;
}
}

TEST(TubeTransfer, RingGoesToTheSameRatioOfALongerThickerTube)
{
  const Tube source = MakeTube({});
  const Tube target = MakeTube(LongAndThick());
  const auto height = [](double) { return 0.3; };
  const TransferResult result = Transfer(source, target, CutTube(source, height));
  EXPECT_GT(Agreement(target, result, height), 0.985);
  ASSERT_EQ(result.Boundaries.size(), 1u);
  const BoundaryPair& pair = result.Boundaries.front();
  EXPECT_TRUE(pair.EnclosesBranch);
  ASSERT_EQ(pair.TargetPoints.size(), pair.SourcePoints.size());
  for (std::size_t i = 0; i < pair.TargetPoints.size(); ++i)
  {
    // An edge is 0.125 long; a source ring on edges wavers by its own 0.067 x 2.
    EXPECT_NEAR(pair.TargetPoints[i].z(), -4.0 + 0.3 * 8.0, 0.25);
    EXPECT_NEAR(pair.TargetPoints[i].head<2>().norm(), 0.9, 0.01);
  }
}

TEST(TubeTransfer, PointsCorrespondRoundTheTube)
{
  const Tube source = MakeTube({});
  const Tube target = MakeTube(LongAndThick());
  const TransferResult result =
    Transfer(source, target, CutTube(source, [](double) { return 0.6; }));
  ASSERT_EQ(result.Boundaries.size(), 1u);
  const BoundaryPair& pair = result.Boundaries.front();
  ASSERT_EQ(pair.TargetPoints.size(), pair.SourcePoints.size());
  // A circle says nothing about its turn; but neighbours stay neighbours, the same way round.
  double turn = 0.0;
  for (std::size_t i = 0; i < pair.TargetPoints.size(); ++i)
  {
    const std::size_t next = (i + 1) % pair.TargetPoints.size();
    const auto angle = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
    { return std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()); };
    const double there = angle(pair.TargetPoints[i], pair.TargetPoints[next]);
    const double here = angle(pair.SourcePoints[i], pair.SourcePoints[next]);
    EXPECT_NEAR(there, here, 0.05);
    turn += there;
  }
  EXPECT_NEAR(std::abs(turn), 2.0 * Pi, 1e-6);
}

TEST(TubeTransfer, TiltedRingKeepsItsTilt)
{
  const Tube source = MakeTube({});
  TubeOptions options = LongAndThick();
  options.Length = 7.2; // as slender as the source
  const Tube target = MakeTube(options);
  const auto height = [](double angle) { return 0.5 + 0.08 * std::cos(angle - 0.4); };
  EXPECT_GT(Agreement(target, Transfer(source, target, CutTube(source, height)), height), 0.98);
}

TEST(TubeTransfer, WavyRingKeepsItsShape)
{
  TubeOptions fine;
  fine.Around = 48;
  fine.Along = 90;
  const Tube source = MakeTube(fine);
  TubeOptions options = fine;
  options.Radius = 1.0;
  options.Length = 8.0;
  const Tube target = MakeTube(options);
  const auto height = [](double angle) { return 0.5 + 0.05 * std::cos(2.0 * angle); };
  const TransferResult result = Transfer(source, target, CutTube(source, height));
  EXPECT_GT(Agreement(target, result, height), 0.985);
}

TEST(TubeTransfer, RingFollowsABend)
{
  const Tube source = MakeTube({});
  TubeOptions options = LongAndThick();
  constexpr double bendRadius = 4.0;
  options.Bend = [](const Eigen::Vector3d& p) -> Eigen::Vector3d
  {
    const double angle = p.z() / bendRadius;
    return { (p.x() + bendRadius) * std::cos(angle), p.y(),
      (p.x() + bendRadius) * std::sin(angle) };
  };
  const Tube target = MakeTube(options);
  for (double ratio : { 0.25, 0.7 })
  {
    const auto height = [ratio](double) { return ratio; };
    EXPECT_GT(Agreement(target, Transfer(source, target, CutTube(source, height)), height), 0.98)
      << ratio;
  }
}

TEST(TubeTransfer, GhostBoundariesPullTheRing)
{
  // The thickness changes at 0.5 of the source and at 0.58 of the target; the boundary is there.
  const auto peak = [](double at)
  { return [at](double f) { return 0.05 + std::exp(-0.5 * std::pow((f - at) / 0.03, 2.0)); }; };
  TubeOptions sourceOptions;
  sourceOptions.Gradient = peak(0.5);
  TubeOptions targetOptions = LongAndThick();
  targetOptions.Gradient = peak(0.58);
  const Tube source = MakeTube(sourceOptions);
  const Tube target = MakeTube(targetOptions);
  const TransferResult result =
    Transfer(source, target, CutTube(source, [](double) { return 0.5; }), true);
  EXPECT_GT(Agreement(target, result, [](double) { return 0.58; }), 0.98);
}

TEST(TubeTransfer, PatchOnTheSideIsCarriedByTheMap)
{
  // It encloses no branch.
  const Tube source = MakeTube({});
  const Tube target = MakeTube(LongAndThick());
  const auto patch = [](const Tube& tube)
  {
    std::vector<int> labels;
    for (std::size_t t = 0; t < tube.Fraction.size(); ++t)
    {
      labels.push_back(
        std::abs(tube.Fraction[t] - 0.5) < 0.15 && std::abs(tube.Angle[t]) < 1.0 ? 7 : 3);
    }
    return labels;
  };
  const TransferResult result = Transfer(source, target, patch(source));
  const std::vector<int> expected = patch(target);
  double both = 0.0;
  double either = 0.0;
  for (std::size_t t = 0; t < expected.size(); ++t)
  {
    both += expected[t] == 7 && result.Labels[t] == 7 ? 1.0 : 0.0;
    either += expected[t] == 7 || result.Labels[t] == 7 ? 1.0 : 0.0;
  }
  EXPECT_GT(both / either, 0.75);
  ASSERT_EQ(result.Boundaries.size(), 1u);
  EXPECT_FALSE(result.Boundaries[0].EnclosesBranch);
  EXPECT_EQ(result.Boundaries[0].TargetPoints.size(), result.Boundaries[0].SourcePoints.size());

  // The paper's own way drops it.
  const TransferResult dropped = Transfer(source, target, patch(source), true);
  EXPECT_EQ(std::count(dropped.Labels.begin(), dropped.Labels.end(), 7), 0);
  EXPECT_EQ(dropped.MissingLabels, std::vector<int>{ 7 });
}

TEST(TubeTransfer, AbortStops)
{
  const Tube tube = MakeTube({});
  int calls = 0;
  const TransferResult result = TransferSegmentation(tube.Analyzed, tube.Analyzed,
    { { MatchTubes(tube, tube), 0.0, 1.0, 0.0 } }, CutTube(tube, [](double) { return 0.5; }),
    TransferParameters(), {}, [&](double) { return ++calls < 3; });
  EXPECT_TRUE(result.IsAborted);
  EXPECT_EQ(calls, 3);
}
