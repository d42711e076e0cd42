// SPDX-License-Identifier: BSD-3-Clause
#include "LabelCut.h"
#include "MinimumCut.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace marrow;

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
