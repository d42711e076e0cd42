// SPDX-License-Identifier: BSD-3-Clause
#include "LinearAssignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

using namespace marrow;

TEST(LinearAssignment, EndsWithCostsThatAreNoNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  Eigen::MatrixXd cost(3, 3);
  cost << nan, 1.0, nan, 2.0, nan, infinite, nan, nan, 3.0;
  EXPECT_EQ(AssignRows(cost), (std::vector<int>{ 1, 0, 2 }));
  EXPECT_EQ(AssignRows(Eigen::MatrixXd::Constant(2, 2, nan)).size(), 2u);
}

TEST(LinearAssignment, IsTheBestOfAllOrders)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial)
  {
    const int rows = 2 + trial % 4;
    const int columns = 2 + trial % 5;
    Eigen::MatrixXd cost(rows, columns);
    for (int r = 0; r < rows; ++r)
    {
      for (int c = 0; c < columns; ++c)
      {
        cost(r, c) = uniform(random);
      }
    }
    const std::vector<int> found = AssignRows(cost);
    double sum = 0.0;
    int matched = 0;
    for (int r = 0; r < rows; ++r)
    {
      sum += found[r] >= 0 ? cost(r, found[r]) : 0.0;
      matched += found[r] >= 0 ? 1 : 0;
    }
    EXPECT_EQ(std::min(rows, columns), matched);
    // Every order of the larger side.
    const bool wide = columns >= rows;
    std::vector<int> order(std::max(rows, columns));
    std::iota(order.begin(), order.end(), 0);
    double least = 1e30;
    do
    {
      double value = 0.0;
      for (int i = 0; i < std::min(rows, columns); ++i)
      {
        value += wide ? cost(i, order[i]) : cost(order[i], i);
      }
      least = std::min(least, value);
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(least, sum, 1e-12);
  }
}
