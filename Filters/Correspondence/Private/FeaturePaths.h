// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FeaturePaths_h
#define marrow_FeaturePaths_h

#include "FeatureGraph.h"

#include <cstdint>
#include <vector>

namespace marrow
{
/// The shortest paths between the feature nodes of a skeleton.
class FeaturePaths
{
public:
  /// The features with the longest branches are taken if there are more: a set of them has one bit each.
  static constexpr int MaximumFeatures = 48;
  using Mask = std::uint64_t;
  /// How far off a path a feature may be and still be near it, over the longest path.
  static constexpr double NearPath = 0.1;

  explicit FeaturePaths(const FeatureGraph& graph);

  const FeatureGraph& Graph() const { return this->Skeleton; }
  /// Of the features taken, which the functions below number from 0.
  int Size() const { return static_cast<int>(this->Features.size()); }
  int Feature(int i) const { return this->Features[i]; }

  /// Over the longest path of the skeleton; infinite between components.
  double Length(int from, int to) const { return this->Lengths[from * this->Size() + to]; }
  /// The features strictly between the ends of the path.
  Mask Between(int from, int to) const { return this->Insides[from * this->Size() + to]; }
  /// The features between the ends and those near the path: to go there on the way is a detour of twice
  /// NearPath at most.
  Mask Near(int from, int to) const { return this->Nears[from * this->Size() + to]; }
  const std::vector<int>& Darts(int from, int to) const
  {
    return this->Paths[from * this->Size() + to];
  }

private:
  void FindPathsFrom(int from);
  void FindNears();

  const FeatureGraph& Skeleton;
  std::vector<int> Features;
  std::vector<double> Lengths;
  std::vector<Mask> Insides;
  std::vector<Mask> Nears;
  std::vector<std::vector<int>> Paths;
};
}

#endif
