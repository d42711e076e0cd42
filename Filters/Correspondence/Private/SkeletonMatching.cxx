// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonMatching.h"

#include <algorithm>

namespace marrow
{
namespace
{
void MarkNodes(
  const FeatureGraph& graph, const FeatureGroup& group, int id, SkeletonMatch::Side& side)
{
  for (int feature : group.Features)
  {
    side.NodeId[graph.GetFeatures()[feature].Node] = id;
  }
}

void MarkBranches(
  const FeatureGraph& graph, const std::vector<int>& path, int id, SkeletonMatch::Side& side)
{
  int order = 0;
  for (int dart : path)
  {
    const int branch = graph.SkeletonBranch(dart);
    side.BranchId[branch] = id;
    side.BranchOrder[branch] = order++;
    side.BranchReversed[branch] = graph.RunsAgainst(dart) ? 1 : 0;
  }
}

SkeletonMatch::Side EmptySide(const Skeleton& skeleton)
{
  SkeletonMatch::Side side;
  side.NodeId.assign(skeleton.NumberOfNodes(), -1);
  side.BranchId.assign(skeleton.NumberOfBranches(), -1);
  side.BranchOrder.assign(skeleton.NumberOfBranches(), -1);
  side.BranchReversed.assign(skeleton.NumberOfBranches(), 0);
  return side;
}
}

bool MatchSkeletons(const Skeleton& source, const Skeleton& target,
  const MatchingParameters& parameters, SkeletonMatching& result, const Progress& progress)
{
  const FeatureGraph sourceGraph(source, parameters.DescriptorPieces);
  const FeatureGraph targetGraph(target, parameters.DescriptorPieces);
  CorrespondenceTree tree(sourceGraph, targetGraph, parameters.Tree);
  if (!tree.Grow(SubProgress(progress, 0.0, 0.9)))
  {
    return false;
  }
  std::vector<RatedLeaf> leaves =
    RateLeaves(sourceGraph, targetGraph, tree.GetLeaves(), parameters.GlobalSelection);
  if (leaves.empty())
  {
    leaves.emplace_back();
  }
  result = SkeletonMatching();
  result.Statistics = tree.GetStatistics();
  for (const RatedLeaf& leaf : leaves)
  {
    SkeletonMatch match;
    match.Source = EmptySide(source);
    match.Target = EmptySide(target);
    for (std::size_t i = 0; i < leaf.Match.Nodes.size(); ++i)
    {
      const MatchedNodes& nodes = leaf.Match.Nodes[i];
      MarkNodes(sourceGraph, nodes.Source, static_cast<int>(i), match.Source);
      MarkNodes(targetGraph, nodes.Target, static_cast<int>(i), match.Target);
      const bool terminal = sourceGraph.GetFeatures()[nodes.Source.Features[0]].IsTerminal();
      ++(terminal ? match.TerminalPairs : match.JunctionPairs);
    }
    for (std::size_t i = 0; i < leaf.Match.Branches.size(); ++i)
    {
      const MatchedBranches& branches = leaf.Match.Branches[i];
      MarkBranches(sourceGraph, branches.Source, static_cast<int>(i), match.Source);
      MarkBranches(targetGraph, branches.Target, static_cast<int>(i), match.Target);
    }
    match.BranchPairs = static_cast<int>(leaf.Match.Branches.size());
    match.Merges = leaf.Match.Merges;
    match.PaperCost = leaf.PaperCost;
    match.GlobalCost = leaf.GlobalCost;
    match.Refined = leaf.Refined;
    match.Confidence = Confidence(leaf);
    match.SourceCoverage = leaf.SourceCoverage;
    match.TargetCoverage = leaf.TargetCoverage;
    result.Leaves.push_back(std::move(match));
  }
  return Report(progress, 1.0);
}
}
