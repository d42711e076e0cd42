// SPDX-License-Identifier: BSD-3-Clause
#include "NodeConsensus.h"

#include "BranchCosts.h"
#include "BranchLikeness.h"
#include "JunctionCost.h"
#include "LoopDirection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
using Pairs = std::vector<std::pair<int, int>>;

/// A pair of chains that may be matched.
struct Candidate
{
  MatchedBranches Branches;
  double Unlikeness = 0.0;
};

/// Adds the candidates whose branches are free, the most alike first.
class BranchChooser
{
public:
  BranchChooser(const FeatureGraph& source, const FeatureGraph& target)
    : SourceUsed(source.NumberOfBranches(), false)
    , TargetUsed(target.NumberOfBranches(), false)
  {
  }
  void Choose(std::vector<Candidate> candidates, FeatureCorrespondence& match)
  {
    std::stable_sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.Unlikeness < b.Unlikeness; });
    for (const Candidate& candidate : candidates)
    {
      if (IsFree(candidate.Branches.Source, this->SourceUsed) &&
        IsFree(candidate.Branches.Target, this->TargetUsed))
      {
        Take(candidate.Branches.Source, this->SourceUsed);
        Take(candidate.Branches.Target, this->TargetUsed);
        match.Branches.push_back(candidate.Branches);
      }
    }
  }

private:
  static bool IsFree(const std::vector<int>& darts, const std::vector<bool>& used)
  {
    return std::none_of(
      darts.begin(), darts.end(), [&](int dart) { return static_cast<bool>(used[dart / 2]); });
  }
  static void Take(const std::vector<int>& darts, std::vector<bool>& used)
  {
    for (const int dart : darts)
    {
      used[dart / 2] = true;
    }
  }

  std::vector<bool> SourceUsed;
  std::vector<bool> TargetUsed;
};

/// The matched pairs that a path passes.
bool IsDirect(const FeaturePaths& paths, int from, int to, FeaturePaths::Mask matched)
{
  return paths.Length(from, to) < std::numeric_limits<double>::infinity() &&
    (paths.Between(from, to) & matched) == 0;
}

std::vector<Candidate> ChainsBetween(
  const FeaturePaths& source, const FeaturePaths& target, const Pairs& pairs)
{
  FeaturePaths::Mask sourceMatched = 0;
  FeaturePaths::Mask targetMatched = 0;
  for (const auto& [s, t] : pairs)
  {
    sourceMatched |= FeaturePaths::Mask(1) << s;
    targetMatched |= FeaturePaths::Mask(1) << t;
  }
  std::vector<Candidate> result;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    for (std::size_t k = i + 1; k < pairs.size(); ++k)
    {
      const auto [s, t] = pairs[i];
      const auto [u, v] = pairs[k];
      if (IsDirect(source, s, u, sourceMatched) && IsDirect(target, t, v, targetMatched))
      {
        result.push_back(
          { { source.Darts(s, u), target.Darts(t, v), static_cast<int>(i), static_cast<int>(k) },
            // The fewest branches first: a chain shall not take what another needs.
            std::abs(source.Length(s, u) - target.Length(t, v)) +
              static_cast<double>(source.Darts(s, u).size() + target.Darts(t, v).size()) });
      }
    }
  }
  return result;
}

/// Single branches between matched nodes, whether the shortest path or not.
std::vector<Candidate> BranchesBetween(
  const FeaturePaths& source, const FeaturePaths& target, const FeatureCorrespondence& match)
{
  const FeatureGraph& s = source.Graph();
  const FeatureGraph& t = target.Graph();
  const auto nodesOf = [&](const FeatureGraph& graph, FeatureGroup MatchedNodes::*side)
  {
    std::vector<int> result(graph.NumberOfFeatures(), -1);
    for (std::size_t i = 0; i < match.Nodes.size(); ++i)
    {
      result[(match.Nodes[i].*side).Features.front()] = static_cast<int>(i);
    }
    return result;
  };
  const std::vector<int> sourceNodes = nodesOf(s, &MatchedNodes::Source);
  const std::vector<int> targetNodes = nodesOf(t, &MatchedNodes::Target);
  std::vector<Candidate> result;
  for (int b = 0; b < s.NumberOfBranches(); ++b)
  {
    const int first = sourceNodes[s.Origin(2 * b)];
    const int last = sourceNodes[s.Head(2 * b)];
    for (int dart = 0; first >= 0 && last >= 0 && dart < 2 * t.NumberOfBranches(); ++dart)
    {
      if (targetNodes[t.Origin(dart)] != first || targetNodes[t.Head(dart)] != last ||
        (first == last && dart % 2 == 1))
      {
        continue;
      }
      const int directed = first == last ? DirectLoop(s, t, match, first, 2 * b, dart) : dart;
      result.push_back({ { { 2 * b }, { directed }, first, last },
        PathUnlikeness(s, { 2 * b }, t, { directed }) });
    }
  }
  return result;
}
}

FeatureCorrespondence MatchByNodes(
  const FeaturePaths& source, const FeaturePaths& target, const Pairs& pairs)
{
  const FeatureGraph& s = source.Graph();
  const FeatureGraph& t = target.Graph();
  FeatureCorrespondence match;
  for (const auto& [i, j] : pairs)
  {
    MatchedNodes nodes;
    nodes.Source.Features = { source.Feature(i) };
    nodes.Target.Features = { target.Feature(j) };
    if (!s.GetFeatures()[source.Feature(i)].IsTerminal())
    {
      nodes.Cost = JunctionCost(s, nodes.Source, t, nodes.Target);
      match.JunctionCosts.push_back(nodes.Cost);
    }
    match.Nodes.push_back(nodes);
  }
  BranchChooser chooser(s, t);
  chooser.Choose(ChainsBetween(source, target, pairs), match);
  for (const MatchedBranches& branches : match.Branches)
  {
    match.Merges += static_cast<int>(branches.Source.size() + branches.Target.size()) - 2;
  }
  chooser.Choose(BranchesBetween(source, target, match), match);
  AddBranchCosts(match, s, t);
  return match;
}
}
