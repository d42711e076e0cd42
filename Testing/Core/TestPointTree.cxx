// SPDX-License-Identifier: BSD-3-Clause
#include "PointTree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace marrow;

namespace
{
std::vector<Eigen::Vector3d> RandomPoints(int count)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<Eigen::Vector3d> points(count);
  for (Eigen::Vector3d& point : points)
  {
    point = { coordinate(random), coordinate(random), 0.1 * coordinate(random) };
  }
  return points;
}

int Nearest(const PointTree& tree, const Eigen::Vector3d& place, double squaredReach)
{
  int nearest = -1;
  tree.Search(place, squaredReach,
    [&](int number, double squared)
    {
      if (nearest < 0 || squared < squaredReach)
      {
        squaredReach = squared;
        nearest = number;
      }
      return squaredReach;
    });
  return nearest;
}
}

TEST(PointTree, FindsWhatLookingAtAllFinds)
{
  const std::vector<Eigen::Vector3d> points = RandomPoints(1000);
  const PointTree tree(points);
  for (const Eigen::Vector3d& place : RandomPoints(200))
  {
    int nearest = 0;
    for (int i = 1; i < 1000; ++i)
    {
      if ((points[i] - place).squaredNorm() < (points[nearest] - place).squaredNorm())
      {
        nearest = i;
      }
    }
    EXPECT_EQ(Nearest(tree, place, std::numeric_limits<double>::infinity()), nearest);
    const double exact = (points[nearest] - place).squaredNorm();
    EXPECT_EQ(Nearest(tree, place, exact), nearest);
    EXPECT_EQ(Nearest(tree, place, 0.99 * exact - 1e-12), -1);
  }
}

TEST(PointTree, OnlySomePointsAndPointsInOnePlace)
{
  const std::vector<Eigen::Vector3d> points(50, Eigen::Vector3d(1.0, 2.0, 3.0));
  int count = 0;
  const auto visit = [&](int number, double squared)
  {
    EXPECT_EQ(number % 2, 0);
    EXPECT_EQ(squared, 0.0);
    ++count;
    return 0.0;
  };
  std::vector<int> even;
  for (int i = 0; i < 50; i += 2)
  {
    even.push_back(i);
  }
  PointTree(points, even).Search(points.front(), 0.0, visit);
  EXPECT_EQ(count, 25);
  PointTree(points, {}).Search(points.front(), 0.0, visit);
  PointTree().Search(points.front(), 0.0, visit);
  EXPECT_EQ(count, 25);
}
