// SPDX-License-Identifier: BSD-3-Clause
#include "LeafSelection.h"

#include <algorithm>

namespace marrow
{
namespace
{
double Coverage(const FeatureGraph& graph, const FeatureCorrespondence& match,
  std::vector<int> MatchedBranches::*path)
{
  double length = 0.0;
  for (const MatchedBranches& branches : match.Branches)
  {
    length += graph.Length(branches.*path);
  }
  return length;
}
}

std::vector<RatedLeaf> RateLeaves(const FeatureGraph& source, const FeatureGraph& target,
  const std::vector<FeatureCorrespondence>& leaves, bool global)
{
  double largestJunction = 0.0;
  double largestBranch = 0.0;
  for (const FeatureCorrespondence& leaf : leaves)
  {
    for (double cost : leaf.JunctionCosts)
    {
      largestJunction = std::max(largestJunction, cost);
    }
    for (double cost : leaf.BranchCosts)
    {
      largestBranch = std::max(largestBranch, cost);
    }
  }
  std::vector<RatedLeaf> result;
  for (const FeatureCorrespondence& leaf : leaves)
  {
    RatedLeaf rated;
    rated.Match = leaf;
    rated.PaperCost = 1.0;
    for (double cost : leaf.JunctionCosts)
    {
      rated.PaperCost *= cost / largestJunction;
    }
    for (double cost : leaf.BranchCosts)
    {
      rated.PaperCost *= cost / largestBranch;
    }
    rated.SourceCoverage = Coverage(source, leaf, &MatchedBranches::Source);
    rated.TargetCoverage = Coverage(target, leaf, &MatchedBranches::Target);
    rated.GlobalCost = rated.PaperCost;
    result.push_back(std::move(rated));
  }
  std::stable_sort(result.begin(), result.end(),
    [&](const RatedLeaf& a, const RatedLeaf& b)
    { return global ? a.GlobalCost < b.GlobalCost : a.PaperCost < b.PaperCost; });
  return result;
}
}
