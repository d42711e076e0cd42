// SPDX-License-Identifier: BSD-3-Clause
#include "LeafSelection.h"

#include "BeamSearch.h"
#include "GlobalCost.h"
#include "LeafRefinement.h"
#include "SplitConsensus.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace marrow
{
namespace
{
/// Leaves that the searches start from; work is bounded by it, and most end in the same places.
constexpr std::size_t MaximumStarts = 12;

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

/// The surface along a path: the integral of MSP, in the units of the graph.
double SurfaceOf(const FeatureGraph& graph, const std::vector<int>& darts)
{
  /// Of the sum that stands for the integral; a branch has hardly more bulges.
  constexpr int pieces = 16;
  double surface = 0.0;
  for (const int dart : darts)
  {
    const std::vector<double> profile = graph.Profile({ dart }, FeatureGraph::Measure::MSP, pieces);
    surface +=
      graph.Length(dart / 2) * std::accumulate(profile.begin(), profile.end(), 0.0) / pieces;
  }
  return surface;
}

double TotalSurface(const FeatureGraph& graph)
{
  double surface = 0.0;
  for (int branch = 0; branch < graph.NumberOfBranches(); ++branch)
  {
    surface += SurfaceOf(graph, { 2 * branch });
  }
  return surface;
}

/// How unlike the surface is shared out among the matched branches, in [0,1]: 0 if all is matched
/// and every part has the same share on both sides. A head is not a tail, whatever its form.
double SurfaceUnlike(
  const FeatureGraph& source, const FeatureGraph& target, const FeatureCorrespondence& match)
{
  const double sourceTotal = TotalSurface(source);
  const double targetTotal = TotalSurface(target);
  if (!(sourceTotal > 0.0) || !(targetTotal > 0.0))
  {
    return 0.0;
  }
  double common = 0.0;
  for (const MatchedBranches& branches : match.Branches)
  {
    common += std::min(SurfaceOf(source, branches.Source) / sourceTotal,
      SurfaceOf(target, branches.Target) / targetTotal);
  }
  return 1.0 - common;
}

RatedLeaf Rate(
  const FeatureGraph& source, const FeatureGraph& target, const FeatureCorrespondence& match)
{
  RatedLeaf rated;
  rated.Match = match;
  rated.SourceCoverage = Coverage(source, match, &MatchedBranches::Source);
  rated.TargetCoverage = Coverage(target, match, &MatchedBranches::Target);
  return rated;
}

void AddPaperCosts(std::vector<RatedLeaf>& leaves)
{
  double largestJunction = 0.0;
  double largestBranch = 0.0;
  for (const RatedLeaf& leaf : leaves)
  {
    for (double cost : leaf.Match.JunctionCosts)
    {
      largestJunction = std::max(largestJunction, cost);
    }
    for (double cost : leaf.Match.BranchCosts)
    {
      largestBranch = std::max(largestBranch, cost);
    }
  }
  for (RatedLeaf& leaf : leaves)
  {
    leaf.PaperCost = 1.0;
    for (double cost : leaf.Match.JunctionCosts)
    {
      leaf.PaperCost *= cost / largestJunction;
    }
    for (double cost : leaf.Match.BranchCosts)
    {
      leaf.PaperCost *= cost / largestBranch;
    }
  }
}

/// Order-independent key of a matching, to find leaves that match the same.
using Statement = std::set<std::vector<std::vector<int>>>;

Statement StatementOf(const FeatureCorrespondence& match)
{
  Statement parts;
  for (const MatchedNodes& nodes : match.Nodes)
  {
    parts.insert({ nodes.Source.Features, nodes.Target.Features });
  }
  for (const MatchedBranches& branches : match.Branches)
  {
    std::vector<std::vector<int>> chains{ branches.Source, branches.Target, { 0 } };
    for (std::vector<int>* chain : { &chains[0], &chains[1] })
    {
      std::transform(
        chain->begin(), chain->end(), chain->begin(), [](int dart) { return dart / 2; });
      std::sort(chain->begin(), chain->end());
    }
    parts.insert(chains);
  }
  return parts;
}

/// Of leaves that say the same the first stays.
void RemoveRepetitions(std::vector<RatedLeaf>& leaves)
{
  std::set<Statement> said;
  leaves.erase(
    std::remove_if(leaves.begin(), leaves.end(),
      [&](const RatedLeaf& leaf) { return !said.insert(StatementOf(leaf.Match)).second; }),
    leaves.end());
}

void SortBy(std::vector<RatedLeaf>& leaves, double RatedLeaf::*cost)
{
  std::stable_sort(leaves.begin(), leaves.end(),
    [cost](const RatedLeaf& a, const RatedLeaf& b)
    { return a.CostOfHints + a.*cost < b.CostOfHints + b.*cost; });
}

double MeanCoverage(const RatedLeaf& leaf)
{
  return 0.5 * (leaf.SourceCoverage + leaf.TargetCoverage);
}

/// What the first leaves say of the terminals.
std::vector<GlobalCost::Assignment> FirstAssignments(
  const TerminalPaths& source, const TerminalPaths& target, const std::vector<RatedLeaf>& leaves)
{
  std::vector<GlobalCost::Assignment> first;
  for (std::size_t i = 0; i < std::min(leaves.size(), MaximumStarts); ++i)
  {
    first.push_back(TerminalAssignment(source, target, leaves[i].Match));
  }
  return first;
}

/// Leaves of the assignments that were found, as far as no other leaf says the same.
std::vector<RatedLeaf> LeavesOf(const TerminalPaths& source, const TerminalPaths& target,
  const std::vector<GlobalCost::Assignment>& found, const std::vector<RatedLeaf>& others)
{
  std::set<Statement> said;
  for (const RatedLeaf& leaf : others)
  {
    said.insert(StatementOf(leaf.Match));
  }
  std::vector<RatedLeaf> refined;
  for (const GlobalCost::Assignment& assignment : found)
  {
    const FeatureCorrespondence match = MatchBySplits(source, target, assignment);
    if (!match.Nodes.empty() && said.count(StatementOf(match)) == 0)
    {
      refined.push_back(Rate(source.Graph(), target.Graph(), match));
      refined.back().Refined = true;
    }
  }
  return refined;
}
}

std::vector<RatedLeaf> RateLeaves(const FeatureGraph& source, const FeatureGraph& target,
  const std::vector<FeatureCorrespondence>& leaves, const MatchingWeights& weights, bool global,
  const std::vector<NodeHint>& hints)
{
  const TerminalPaths sourcePaths(source);
  const TerminalPaths targetPaths(target);
  const GlobalCost cost(sourcePaths, targetPaths, weights, hints);
  const auto rateGlobally = [&](std::vector<RatedLeaf>& some)
  {
    for (RatedLeaf& leaf : some)
    {
      const GlobalCost::Assignment terminals =
        TerminalAssignment(sourcePaths, targetPaths, leaf.Match);
      leaf.CostOfHints = cost.OfHints(terminals);
      leaf.GlobalCost = cost.Total(terminals) - leaf.CostOfHints +
        weights.Coverage * (1.0 - MeanCoverage(leaf)) +
        weights.Surface * SurfaceUnlike(source, target, leaf.Match);
    }
  };
  std::vector<RatedLeaf> result;
  for (const FeatureCorrespondence& leaf : leaves)
  {
    result.push_back(Rate(source, target, leaf));
  }
  rateGlobally(result);
  if (global && source.NumberOfComponents() == 1 && target.NumberOfComponents() == 1)
  {
    const auto add = [&](const std::vector<GlobalCost::Assignment>& found)
    {
      std::vector<RatedLeaf> refined = LeavesOf(sourcePaths, targetPaths, found, result);
      rateGlobally(refined);
      result.insert(result.begin(), refined.begin(), refined.end());
      SortBy(result, &RatedLeaf::GlobalCost);
    };
    SortBy(result, &RatedLeaf::GlobalCost);
    std::vector<GlobalCost::Assignment> starts = FirstAssignments(sourcePaths, targetPaths, result);
    starts.insert(starts.begin(), cost.Guess());
    add(Descend(cost, targetPaths, starts));
    add(FindOthers(
      cost, sourcePaths, targetPaths, FirstAssignments(sourcePaths, targetPaths, result)));
  }
  AddPaperCosts(result);
  SortBy(result, global ? &RatedLeaf::GlobalCost : &RatedLeaf::PaperCost);
  RemoveRepetitions(result);
  return result;
}

double Confidence(const RatedLeaf& leaf)
{
  /// The cost at which half of the terminals are right, and how fast that changes: a logistic regression on
  /// labelled meshes.
  constexpr double even = 0.62;
  constexpr double width = 0.12;
  // Nothing matched costs most, and is surely no answer.
  return leaf.Match.Branches.empty() ? 0.0
                                     : 1.0 / (1.0 + std::exp((leaf.GlobalCost - even) / width));
}
}
