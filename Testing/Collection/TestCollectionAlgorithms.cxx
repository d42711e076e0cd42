// SPDX-License-Identifier: BSD-3-Clause
#include "ContentKey.h"
#include "LabelShares.h"
#include "PairSelection.h"
#include "SharesCut.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

using namespace marrow;
using namespace marrow::test;

TEST(LabelShares, LinksAreWeighted)
{
  const std::vector<int> labels = DifferentLabels({ { 7, 3 }, {}, { 3, -1 } });
  EXPECT_EQ(labels, (std::vector<int>{ -1, 3, 7 }));
  const LabelShares one = SharesOfLabels({ 3, 7 }, labels);
  const LabelShares other = SharesOfLabels({ -1, 7 }, labels);
  const std::vector<int> found{ 0, 1 };
  const std::vector<float> unsure{ 0.0f, 1.0f };
  LabelShares sum =
    GatherShares({ { &one, &found, nullptr, 3.0 }, { &other, &found, &unsure, 2.0 }, {} }, 2, 3);
  SharpenShares(sum, 1.0);
  EXPECT_FLOAT_EQ(sum(0, 1), 0.75f); // the other counts half where it is unsure
  EXPECT_FLOAT_EQ(sum(0, 0), 0.25f);
  EXPECT_FLOAT_EQ(sum(1, 2), 1.0f);
  SharpenShares(sum, 2.0);
  EXPECT_FLOAT_EQ(sum(0, 1), 0.9f);
}

TEST(LabelShares, NothingKnownStaysNothing)
{
  LabelShares shares = GatherShares({}, 3, 2);
  SharpenShares(shares, 1.5);
  EXPECT_EQ(shares.sum(), 0.0f);
}

TEST(PairSelection, SmallCollectionsAreMatchedInFull)
{
  const std::vector<std::vector<double>> sketches(5, { 1.0 });
  const auto pairs = SelectPairs(sketches, { 0, 0, 1, 2, 3 }, { false, false, false, true, true },
    { true, true, true, false, false });
  // Not two bodies of one mesh, and not two sources.
  EXPECT_EQ(pairs.size(), 10u - 1u - 1u);
  EXPECT_FALSE(std::count(pairs.begin(), pairs.end(), std::make_pair(0, 1)));
  EXPECT_FALSE(std::count(pairs.begin(), pairs.end(), std::make_pair(3, 4)));
}

TEST(PairSelection, LargeCollectionsGrowInProportion)
{
  const auto numberOfPairs = [](int n)
  {
    std::vector<std::vector<double>> sketches;
    std::vector<int> meshes;
    std::vector<bool> isSource;
    std::vector<bool> isTold;
    for (int i = 0; i < n; ++i)
    {
      sketches.push_back({ std::fmod(i * 0.6180339887, 1.0), i % 3 == 0 ? 1.0 : 0.0 });
      meshes.push_back(i);
      isSource.push_back(i % 10 == 0);
      isTold.push_back(!isSource.back());
    }
    const auto pairs = SelectPairs(sketches, meshes, isSource, isTold);
    std::set<int> reached;
    for (const auto& [a, b] : pairs)
    {
      EXPECT_LT(a, b);
      if (isSource[a] || isSource[b])
      {
        reached.insert({ a, b });
      }
    }
    EXPECT_EQ(static_cast<int>(reached.size()), n); // everyone is told by a source
    return static_cast<double>(pairs.size());
  };
  EXPECT_NEAR(numberOfPairs(800) / numberOfPairs(200), 4.0, 0.3);
}

TEST(SharesCut, IslandsJoinAndHabitsAreLearnt)
{
  // A sphere whose halves are segments; a small patch that one wrong map brought.
  const TriangleMesh mesh = MakeSphere(1.0, 4);
  std::vector<int> truth;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    truth.push_back(mesh.Centroid(t).z() > 0.0 ? 4 : 2);
  }
  LabelHabits habits;
  habits.Add(mesh, truth, 1.0);
  EXPECT_NEAR(habits.SmallestPiece(4), 0.5, 0.05);
  EXPECT_EQ(habits.SmallestPiece(9), 0.0);
  LabelShares shares(mesh.NumberOfVertices(), 2);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const Eigen::Vector3d p = mesh.Points[v].normalized();
    const bool isUpper = p.z() > 0.0 && (p - Eigen::Vector3d(0, 0, 1)).norm() > 0.3;
    shares.row(v) << (isUpper ? 0.0f : 1.0f), (isUpper ? 1.0f : 0.0f);
  }
  const CutLabels cut = CutShares(mesh, shares, { 2, 4 }, habits, {});
  int wrong = 0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    wrong += cut.Labels[t] != truth[t] && std::abs(mesh.Centroid(t).z()) > 0.2 ? 1 : 0;
    EXPECT_GE(cut.Shares[t], 0.0);
    EXPECT_LE(cut.Shares[t], 1.0);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(ContentKey, TellsContentsApart)
{
  const auto keyOf = [](const std::string& first, const std::string& second)
  {
    ContentKey key;
    key.Add(first.data(), first.size());
    key.Add(second.data(), second.size());
    return key.Text();
  };
  EXPECT_EQ(keyOf("ab", "c"), keyOf("ab", "c"));
  EXPECT_NE(keyOf("ab", "c"), keyOf("a", "bc"));
  EXPECT_NE(keyOf("ab", "c"), keyOf("ab", "d"));
  EXPECT_EQ(keyOf("", "").size(), 32u);
}
