// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerChoice.h"
#include "AnswerSearch.h"
#include "CoarseMesh.h"
#include "OtherAnswers.h"
#include "SliceChain.h"
#include "TubeShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// A tube three times as thick at its upper end, bent.
Tube Horn(double bendRadius)
{
  TubeOptions options;
  options.Bend = [bendRadius](const Eigen::Vector3d& p) -> Eigen::Vector3d
  {
    const double wide = 1.0 + 0.5 * (p.z() + 2.0);
    const double angle = p.z() / bendRadius;
    return { (wide * p.x() + bendRadius) * std::cos(angle), wide * p.y(),
      (wide * p.x() + bendRadius) * std::sin(angle) };
  };
  Tube tube = MakeTube(options);
  for (int v = 0; v < tube.Analyzed.Mesh.NumberOfVertices(); ++v)
  {
    const int node = tube.Analyzed.NodeOfVertex[v];
    const double wide = 1.0 + 2.0 * node / (tube.Analyzed.Skeleton.NumberOfNodes() - 1.0);
    tube.Analyzed.MSP[v] *= wide;
  }
  const int last = tube.Analyzed.Skeleton.NumberOfNodes() - 1;
  for (int node = 0; node <= last; ++node)
  {
    tube.Analyzed.Skeleton.Graph[node].Radius *= 1.0 + 2.0 * node / last;
    tube.Analyzed.Skeleton.Graph[node].MSP *= 1.0 + 2.0 * node / last;
  }
  return tube;
}

MatchedSkeletons MatchEnds(const Tube& source, const Tube& target, bool reversed)
{
  CorrespondenceIds ids;
  ids.SourceNodes.assign(source.Analyzed.Skeleton.NumberOfNodes(), -1);
  ids.TargetNodes.assign(target.Analyzed.Skeleton.NumberOfNodes(), -1);
  ids.SourceNodes.front() = 0;
  ids.SourceNodes.back() = 1;
  ids.TargetNodes.front() = reversed ? 1 : 0;
  ids.TargetNodes.back() = reversed ? 0 : 1;
  ids.SourceBranches = ids.TargetBranches = { 0 };
  return JoinChains(source.Analyzed.Skeleton, target.Analyzed.Skeleton, ids);
}

std::size_t Choose(const Tube& source, const Tube& target, const std::vector<Answer>& answers,
  const std::vector<SurfaceHint>& hints = {})
{
  return RankAnswers(source.Analyzed, target.Analyzed, answers, hints, {}).Order.front();
}

int LowestVertex(const Tube& tube)
{
  const auto& points = tube.Analyzed.Mesh.Points;
  return static_cast<int>(std::min_element(points.begin(), points.end(),
                            [](const auto& a, const auto& b) { return a.z() < b.z(); }) -
    points.begin());
}
}

TEST(AnswerChoice, TheAnswersAreRankedAndNoiseDoesNotDecide)
{
  using Order = std::vector<std::size_t>;
  EXPECT_EQ(RankAnswers({ 0.5, 0.2, 0.9, 0.3 }), (Order{ 1, 3, 0, 2 }));
  EXPECT_EQ(RankAnswers({ 0.5, 0.499, 0.2, 0.9 }), (Order{ 2, 1, 0, 3 }));
  EXPECT_EQ(RankAnswers({ 0.5, 0.9, 0.495 }), (Order{ 0, 2, 1 }));
}

TEST(AnswerChoice, AHintOutweighsTheSurfaces)
{
  const Tube source = Horn(1000.0);
  const Tube target = Horn(1.5);
  const Answer right{ MatchEnds(source, target, false), 0.3, 1.0, 0.0 };
  const Answer reversed{ MatchEnds(source, target, true), 0.3, 1.0, 0.0 };
  const int low = LowestVertex(source);
  const auto& points = target.Analyzed.Mesh.Points;
  const int high = static_cast<int>(std::max_element(points.begin(), points.end(),
                                      [](const auto& a, const auto& b) { return a.z() < b.z(); }) -
    points.begin());
  EXPECT_EQ(Choose(source, target, { right, reversed }), 0u);
  EXPECT_EQ(Choose(source, target, { right, reversed }, { { low, high, false } }), 1u);
  EXPECT_EQ(
    Choose(source, target, { right, reversed }, { { low, LowestVertex(target), false } }), 0u);
}

TEST(AnswerChoice, TheSurfacesTellTheThickEndFromTheThin)
{
  const Tube source = Horn(1000.0);
  const Tube target = Horn(1.5);
  const Answer right{ MatchEnds(source, target, false), 0.3, 1.0, 0.0 };
  const Answer wrong{ MatchEnds(source, target, true), 0.295, 1.0, 0.0 };
  EXPECT_EQ(Choose(source, target, { wrong, right }), 1u);
  EXPECT_EQ(Choose(source, target, { right, wrong }), 0u);
  // What the skeletons say still counts.
  const Answer cheap{ right.Match, 0.1, 1.0, 0.0 };
  EXPECT_EQ(Choose(source, target, { right, cheap }), 1u);
  // Of equals the first.
  EXPECT_EQ(Choose(source, target, { right, right }), 0u);
}

TEST(AnswerChoice, TheWholeIsTakenOnlyWhereItFitsClearlyBetter)
{
  const Tube source = Horn(1000.0);
  const Tube target = Horn(1.5);
  // The same shape: nothing is to be gained.
  std::vector<Answer> answers{ { MatchEnds(source, source, false), 0.3, 1.0 } };
  AddWhole(source.Analyzed, source.Analyzed, answers);
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_TRUE(answers[1].IsWhole());
  EXPECT_EQ(Choose(source, source, answers), 0u);
  // The skeletons take the thick end for the thin one.
  answers = { { MatchEnds(source, target, true), 0.3, 1.0 } };
  AddWhole(source.Analyzed, target.Analyzed, answers);
  EXPECT_EQ(Choose(source, target, answers), 1u);
}

TEST(AnswerChoice, TheWholeIsAddedOnceAndNotBesideSlices)
{
  Tube tube = MakeTube({});
  std::vector<Answer> answers{ { MatchEnds(tube, tube, false), 0.3, 1.0, 0.25 } };
  AddWhole(tube.Analyzed, tube.Analyzed, answers);
  // Hints that no skeleton can follow must not speak for it.
  EXPECT_EQ(answers[1].CostOfHints, 0.25);
  EXPECT_TRUE(std::all_of(answers[1].Match.Ids.SourceNodes.begin(),
    answers[1].Match.Ids.SourceNodes.end(), [](int id) { return id == -1; }));
  AddWhole(tube.Analyzed, tube.Analyzed, answers);
  EXPECT_EQ(answers.size(), 2u);

  tube.Analyzed.Slices = FindSlices(tube.Analyzed.Mesh);
  ASSERT_TRUE(tube.Analyzed.Slices) << "a tube is a surface of revolution";
  answers.resize(1);
  PreferSlices(tube.Analyzed, tube.Analyzed, answers);
  const std::size_t size = answers.size();
  AddWhole(tube.Analyzed, tube.Analyzed, answers);
  EXPECT_EQ(answers.size(), size);
}

TEST(AnswerChoice, WhereNothingIsMatchedTheCostIsHighest)
{
  const Tube tube = Horn(4.0);
  const std::vector<Answer> answers = FindAnswers(Skeleton(), tube.Analyzed.Skeleton, {}, {});
  ASSERT_FALSE(answers.empty());
  EXPECT_TRUE(answers.front().IsWhole());
  EXPECT_EQ(answers.front().Cost, 1.0);
}

TEST(CoarseMesh, StandsForTheFineMesh)
{
  TubeOptions options;
  options.Around = 48;
  options.Along = 90;
  const Tube tube = MakeTube(options);
  const CoarseMesh coarse = Coarsen(tube.Analyzed);
  const TriangleMesh& mesh = coarse.Side.Mesh;
  ASSERT_EQ(mesh.NumberOfVertices(), 1000);
  EXPECT_NEAR(std::accumulate(coarse.Shares.begin(), coarse.Shares.end(), 0.0), 1.0, 1e-9);
  EXPECT_LT(*std::max_element(coarse.Shares.begin(), coarse.Shares.end()), 4.0 / 1000);
  // The area is that of the tube, and looks outward.
  double area = 0.0;
  double volume = 0.0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    area += mesh.Area(t);
    volume += mesh.AreaVector(t).dot(mesh.Centroid(t)) / 6.0;
  }
  EXPECT_NEAR(area, coarse.Size * coarse.Size, 0.1 * area);
  EXPECT_NEAR(volume, Pi * 0.25 * 4.0, 0.15);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_NEAR(coarse.Side.MSP[v], Pi, 1e-9);
    EXPECT_LT(coarse.Patches[v], coarse.NumberOfPatches);
    EXPECT_GE(coarse.Patches[v], 0);
    const std::vector<int>& own = coarse.Side.Skeleton.Graph[coarse.Side.NodeOfVertex[v]].Vertices;
    EXPECT_TRUE(std::find(own.begin(), own.end(), v) != own.end());
  }
}
