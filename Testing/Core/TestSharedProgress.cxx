// SPDX-License-Identifier: BSD-3-Clause
#include "SharedProgress.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

using namespace marrow;

TEST(SharedProgress, TheThreadThatMadeItReportsForAll)
{
  std::vector<double> told;
  SharedProgress shared(
    [&](double fraction)
    {
      told.push_back(fraction);
      return true;
    });
  std::thread other(
    [&]
    {
      for (int i = 0; i < 50; ++i)
      {
        EXPECT_TRUE(shared.Add(0.01));
      }
    });
  other.join();
  EXPECT_TRUE(told.empty());
  EXPECT_TRUE(shared.Add(0.25));
  EXPECT_TRUE(shared.Add(0.25 + 1e-9));
  ASSERT_EQ(told.size(), 2u);
  EXPECT_NEAR(told[0], 0.75, 1e-12);
  EXPECT_EQ(told[1], 1.0);
}

TEST(SharedProgress, AllAreStopped)
{
  int calls = 0;
  SharedProgress shared(
    [&](double fraction)
    {
      ++calls;
      return fraction < 0.5;
    });
  EXPECT_TRUE(shared.Add(0.4));
  EXPECT_FALSE(shared.Add(0.2));
  std::thread other([&] { EXPECT_FALSE(shared.Add(0.1)); });
  other.join();
  EXPECT_FALSE(shared.Add(0.1));
  EXPECT_EQ(calls, 2);
}
