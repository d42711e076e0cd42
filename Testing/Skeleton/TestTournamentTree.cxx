// SPDX-License-Identifier: BSD-3-Clause
#include "TournamentTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace marrow;

TEST(TournamentTree, KnowsTheFirstOfTheLeast)
{
  std::mt19937 random(1);
  for (const int size : { 1, 2, 3, 100 })
  {
    std::vector<double> values(size, 5.0);
    TournamentTree tree(values);
    EXPECT_EQ(tree.Least(), 0);
    for (int change = 0; change < 1000; ++change)
    {
      const int place = static_cast<int>(random() % size);
      values[place] = static_cast<double>(random() % 50);
      tree.Change(place, values[place]);
      const auto least = std::min_element(values.begin(), values.end());
      ASSERT_EQ(tree.Least(), least - values.begin());
      ASSERT_EQ(tree.ValueAt(tree.Least()), *least);
    }
  }
}
