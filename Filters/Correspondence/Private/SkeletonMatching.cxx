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

bool GrowLeaves(const FeatureGraph& source, const FeatureGraph& target,
  const MatchingParameters& parameters, const Progress& progress, std::vector<RatedLeaf>& leaves,
  TreeStatistics& statistics)
{
  CorrespondenceTree tree(source, target, parameters.Tree);
  if (!tree.Grow(progress))
  {
    return false;
  }
  leaves = RateLeaves(source, target, tree.GetLeaves(), parameters.GlobalSelection);
  statistics = tree.GetStatistics();
  return true;
}

bool VoteForLeaf(const FeatureGraph& source, const FeatureGraph& target,
  const MatchingParameters& parameters, const Progress& progress, std::vector<RatedLeaf>& leaves,
  TreeStatistics& statistics)
{
  ElectorsVoting voting(source, target, parameters.Voting);
  if (!voting.Vote(progress))
  {
    return false;
  }
  // The global cost would refine the winner, which then were no longer the voters' choice.
  constexpr bool global = false;
  leaves = RateLeaves(source, target, { voting.GetMatch() }, global);
  statistics = voting.GetStatistics();
  return true;
}
}

bool MatchSkeletons(const Skeleton& source, const Skeleton& target,
  const MatchingParameters& parameters, SkeletonMatching& result, const Progress& progress)
{
  const FeatureGraph sourceGraph(source, parameters.DescriptorPieces);
  const FeatureGraph targetGraph(target, parameters.DescriptorPieces);
  result = SkeletonMatching();
  std::vector<RatedLeaf> leaves;
  const bool done = parameters.Method == Matcher::ElectorsVoting
    ? VoteForLeaf(sourceGraph, targetGraph, parameters, SubProgress(progress, 0.0, 0.9), leaves,
        result.Statistics)
    : GrowLeaves(sourceGraph, targetGraph, parameters, SubProgress(progress, 0.0, 0.9), leaves,
        result.Statistics);
  if (!done)
  {
    return false;
  }
  if (leaves.empty())
  {
    leaves.emplace_back();
  }
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
