// SPDX-License-Identifier: BSD-3-Clause
#include "PointTree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
constexpr int PointsOfLeaf = 8;

std::vector<int> AllNumbers(std::size_t size)
{
  std::vector<int> numbers(size);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}
}

PointTree::PointTree(const std::vector<Eigen::Vector3d>& points)
  : PointTree(points, AllNumbers(points.size()))
{
}

PointTree::PointTree(const std::vector<Eigen::Vector3d>& points, std::vector<int> numbers)
  : Numbers(std::move(numbers))
{
  if (!this->Numbers.empty())
  {
    this->Build(points, 0, static_cast<int>(this->Numbers.size()));
  }
  this->Points.reserve(this->Numbers.size());
  for (const int number : this->Numbers)
  {
    this->Points.push_back(points[number]);
  }
}

void PointTree::Build(const std::vector<Eigen::Vector3d>& points, int begin, int end)
{
  const std::size_t at = this->Nodes.size();
  this->Nodes.emplace_back();
  if (end - begin <= PointsOfLeaf)
  {
    this->Nodes[at].Begin = begin;
    this->Nodes[at].End = end;
    return;
  }
  Eigen::Vector3d low = points[this->Numbers[begin]];
  Eigen::Vector3d high = low;
  for (int i = begin; i < end; ++i)
  {
    low = low.cwiseMin(points[this->Numbers[i]]);
    high = high.cwiseMax(points[this->Numbers[i]]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(this->Numbers.begin() + begin, this->Numbers.begin() + middle,
    this->Numbers.begin() + end, [&](int a, int b) { return points[a][axis] < points[b][axis]; });
  this->Nodes[at].Axis = axis;
  this->Nodes[at].Split = points[this->Numbers[middle]][axis];
  this->Build(points, begin, middle);
  this->Nodes[at].Second = static_cast<int>(this->Nodes.size());
  this->Build(points, middle, end);
}
}
