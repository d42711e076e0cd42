// SPDX-License-Identifier: BSD-3-Clause
#include "HintCost.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace marrow
{
namespace
{
/// From a node to all terminals, over their mean; infinite where there is no way. Empty if there is none
/// to any.
std::vector<double> DistancesToTerminals(const TerminalPaths& paths, int node)
{
  const std::vector<double> toFeatures = paths.Graph().DistancesFromNode(node);
  std::vector<double> distances;
  double sum = 0.0;
  int reached = 0;
  for (int terminal = 0; terminal < paths.Size(); ++terminal)
  {
    distances.push_back(toFeatures[paths.Feature(terminal)]);
    if (std::isfinite(distances.back()))
    {
      sum += distances.back();
      ++reached;
    }
  }
  if (!(sum > 0.0))
  {
    return {};
  }
  for (double& distance : distances)
  {
    distance *= reached / sum;
  }
  return distances;
}

/// In [0,1].
double Disagreement(double a, double b)
{
  /// (a − b) / (a + b) where a is twice b. Proportions differ: less says nothing.
  constexpr double twice = 1.0 / 3.0;
  if (std::isinf(a) || std::isinf(b))
  {
    return std::isinf(a) == std::isinf(b) ? 0.0 : 1.0;
  }
  const double difference = a + b > 0.0 ? std::abs(a - b) / (a + b) : 0.0;
  return std::max(0.0, difference - twice) / (1.0 - twice);
}

/// The terminal on whose branch a node lies; -1 if there is none. Junctions are on no branch.
int TerminalAtNode(const TerminalPaths& paths, int node)
{
  const FeatureGraph& graph = paths.Graph();
  for (int terminal = 0; terminal < paths.Size(); ++terminal)
  {
    const int dart = graph.GetFeatures()[paths.Feature(terminal)].Darts.front();
    const std::vector<int>& nodes = graph.NodesOf(dart / 2);
    if (std::find(nodes.begin(), nodes.end(), node) != nodes.end() &&
      node != graph.GetFeatures()[graph.Head(dart)].Node)
    {
      return terminal;
    }
  }
  return -1;
}
}

HintCost::HintCost(
  const TerminalPaths& source, const TerminalPaths& target, const std::vector<NodeHint>& hints)
  : Targets(target.Size())
  , PairCosts(source.Size() * target.Size(), 0.0)
{
  for (const NodeHint& hint : hints)
  {
    const int s = TerminalAtNode(source, hint.SourceNode);
    const int t = TerminalAtNode(target, hint.TargetNode);
    if (hint.IsForbidden)
    {
      if (s >= 0 && t >= 0)
      {
        this->ForbiddenBranches.emplace_back(s, t);
        this->PairCosts[s * this->Targets + t] += Weight;
      }
      continue;
    }
    Pair pair{ s, t, {} };
    const std::vector<double> toSources = DistancesToTerminals(source, hint.SourceNode);
    const std::vector<double> toTargets = DistancesToTerminals(target, hint.TargetNode);
    if (!toSources.empty() && !toTargets.empty())
    {
      pair.Costs.resize(this->PairCosts.size());
      for (std::size_t k = 0; k < pair.Costs.size(); ++k)
      {
        pair.Costs[k] =
          Weight * Disagreement(toSources[k / this->Targets], toTargets[k % this->Targets]);
        this->PairCosts[k] += pair.Costs[k];
      }
    }
    this->Pairs.push_back(std::move(pair));
  }
}

double HintCost::Of(const Pair& pair, const std::vector<int>& targetOf) const
{
  const bool areOfTerminals = pair.SourceTerminal >= 0 && pair.TargetTerminal >= 0;
  if (areOfTerminals && targetOf[pair.SourceTerminal] == pair.TargetTerminal)
  {
    return 0.0;
  }
  double sum = 0.0;
  int matched = 0;
  for (std::size_t i = 0; i < targetOf.size(); ++i)
  {
    if (targetOf[i] >= 0 && !pair.Costs.empty())
    {
      sum += pair.Costs[i * this->Targets + targetOf[i]];
      ++matched;
    }
  }
  // Nothing matched keeps to no hint.
  const double ofDistances = matched > 0 ? sum / matched : (pair.Costs.empty() ? 0.0 : Weight);
  const bool areUnmatched = areOfTerminals && targetOf[pair.SourceTerminal] < 0 &&
    std::find(targetOf.begin(), targetOf.end(), pair.TargetTerminal) == targetOf.end();
  return ofDistances + (areUnmatched ? Weight : 0.0);
}

double HintCost::Total(const std::vector<int>& targetOf) const
{
  double total = 0.0;
  for (const Pair& pair : this->Pairs)
  {
    total += this->Of(pair, targetOf);
  }
  for (const auto& [s, t] : this->ForbiddenBranches)
  {
    total += targetOf[s] == t ? Weight : 0.0;
  }
  return total;
}
}
