// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonMatching.h"

#include "LoopOpening.h"
#include "SkeletonFrame.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace marrow
{
namespace
{
/// Every opening tried is a matching of its own.
constexpr int MaximumOpenings = 4;
/// An opening has to bring the cost down to this share: an additional terminal always lowers it a little.
constexpr double WorthOpening = 0.9;

void MarkNodes(const OpenedSkeleton& skeleton, const FeatureGraph& graph, const FeatureGroup& group,
  int id, SkeletonMatch::Side& side)
{
  for (int feature : group.Features)
  {
    side.NodeId[skeleton.GivenNode[graph.GetFeatures()[feature].Node]] = id;
  }
}

void MarkBranches(const OpenedSkeleton& skeleton, const FeatureGraph& graph,
  const std::vector<int>& path, int id, SkeletonMatch::Side& side)
{
  int order = 0;
  for (int dart : path)
  {
    const bool against = graph.RunsAgainst(dart);
    for (const OpenedSkeleton::Part& part :
      skeleton.PartsAlong(graph.SkeletonBranch(dart), against))
    {
      side.BranchId[part.Branch] = id;
      side.BranchOrder[part.Branch] = order++;
      side.BranchReversed[part.Branch] = part.Reversed ? 1 : 0;
    }
  }
}

SkeletonMatch::Side EmptySide(const OpenedSkeleton& skeleton)
{
  SkeletonMatch::Side side;
  side.NodeId.assign(skeleton.GivenNode.size(), -1);
  side.BranchId.assign(skeleton.GivenBranches, -1);
  side.BranchOrder.assign(skeleton.GivenBranches, -1);
  side.BranchReversed.assign(skeleton.GivenBranches, 0);
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
  leaves = RateLeaves(source, target, tree.GetLeaves(), parameters.Weights,
    parameters.GlobalSelection, parameters.Hints);
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
  leaves = RateLeaves(source, target, { voting.GetMatch() }, parameters.Weights, global);
  statistics = voting.GetStatistics();
  return true;
}

/// As MatchSkeletons, with the loops opened that are.
bool MatchOpened(const OpenedSkeleton& source, const OpenedSkeleton& target,
  const MatchingParameters& parameters, SkeletonMatching& result, const Progress& progress)
{
  const FeatureGraph sourceGraph(source.Opened, parameters.DescriptorPieces);
  const FeatureGraph targetGraph(target.Opened, parameters.DescriptorPieces);
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
      MarkNodes(source, sourceGraph, nodes.Source, static_cast<int>(i), match.Source);
      MarkNodes(target, targetGraph, nodes.Target, static_cast<int>(i), match.Target);
      const bool terminal = sourceGraph.GetFeatures()[nodes.Source.Features[0]].IsTerminal();
      ++(terminal ? match.TerminalPairs : match.JunctionPairs);
    }
    for (std::size_t i = 0; i < leaf.Match.Branches.size(); ++i)
    {
      const MatchedBranches& branches = leaf.Match.Branches[i];
      MarkBranches(source, sourceGraph, branches.Source, static_cast<int>(i), match.Source);
      MarkBranches(target, targetGraph, branches.Target, static_cast<int>(i), match.Target);
    }
    match.BranchPairs = static_cast<int>(leaf.Match.Branches.size());
    match.Merges = leaf.Match.Merges;
    match.PaperCost = leaf.PaperCost;
    match.GlobalCost = leaf.GlobalCost;
    match.CostOfHints = leaf.CostOfHints;
    match.Refined = leaf.Refined;
    match.Confidence = Confidence(leaf);
    match.SourceCoverage = leaf.SourceCoverage;
    match.TargetCoverage = leaf.TargetCoverage;
    result.Leaves.push_back(std::move(match));
  }
  return Report(progress, 1.0);
}

/// Opens loops of one skeleton, one after the other, as long as that makes the match cost clearly less.
bool OpenLoops(int surplus, OpenedSkeleton source, OpenedSkeleton target,
  const MatchingParameters& parameters, SkeletonMatching& result, const Progress& progress)
{
  OpenedSkeleton& looped = surplus > 0 ? source : target;
  const int steps = std::min(std::abs(surplus), MaximumOpenings);
  for (int step = 0; step < steps; ++step)
  {
    const OpenedSkeleton before = looped;
    std::optional<OpenedSkeleton> best;
    double bound = WorthOpening * result.Leaves.front().RankedCost();
    const std::vector<OpenedSkeleton::BranchEnd> ends = before.OpenableEnds();
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      looped = before.OpenedAt(ends[i]);
      const auto done = [&](std::size_t tried)
      { return (step + static_cast<double>(tried) / ends.size()) / steps; };
      SkeletonMatching candidate;
      if (!MatchOpened(
            source, target, parameters, candidate, SubProgress(progress, done(i), done(i + 1))))
      {
        return false;
      }
      if (candidate.Leaves.front().RankedCost() < bound)
      {
        bound = candidate.Leaves.front().RankedCost();
        best = looped;
        result = std::move(candidate);
      }
    }
    if (!best)
    {
      break;
    }
    looped = *best;
  }
  return true;
}
}

bool MatchSkeletons(const Skeleton& source, const Skeleton& target,
  const MatchingParameters& parameters, SkeletonMatching& result, const Progress& progress)
{
  // In frames of their own: where the meshes lie must not decide a tie.
  const Skeleton ownSource = ToFrame(source, FrameOf(source));
  const Skeleton ownTarget = ToFrame(target, FrameOf(target));
  const OpenedSkeleton unopenedSource(ownSource);
  const OpenedSkeleton unopenedTarget(ownTarget);
  constexpr double share = 0.5; // of the progress, without loops opened
  const int surplus = source.NumberOfLoops() - target.NumberOfLoops();
  const bool opens =
    surplus != 0 && parameters.Method == Matcher::CorrespondenceTree && parameters.GlobalSelection;
  return MatchOpened(unopenedSource, unopenedTarget, parameters, result,
           SubProgress(progress, 0.0, opens ? share : 1.0)) &&
    (!opens ||
      OpenLoops(surplus, unopenedSource, unopenedTarget, parameters, result,
        SubProgress(progress, share, 1.0)));
}
}
