// SPDX-License-Identifier: BSD-3-Clause
#include "HintCost.h"

#include <algorithm>
#include <cmath>

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
    if (s >= 0 && t >= 0)
    {
      this->SameBranches.emplace_back(s, t);
    }
    const std::vector<double> toSources = DistancesToTerminals(source, hint.SourceNode);
    const std::vector<double> toTargets = DistancesToTerminals(target, hint.TargetNode);
    if (toSources.empty() || toTargets.empty())
    {
      continue;
    }
    ++this->NumberOfDistances;
    for (int i = 0; i < source.Size(); ++i)
    {
      for (int j = 0; j < target.Size(); ++j)
      {
        this->PairCosts[i * this->Targets + j] += Weight * Disagreement(toSources[i], toTargets[j]);
      }
    }
  }
}

double HintCost::Total(const std::vector<int>& targetOf) const
{
  double sum = 0.0;
  int pairs = 0;
  for (std::size_t i = 0; i < targetOf.size(); ++i)
  {
    if (targetOf[i] >= 0)
    {
      sum += this->OfPair(static_cast<int>(i), targetOf[i]);
      ++pairs;
    }
  }
  // Nothing matched keeps to no hint.
  double total = pairs > 0 ? sum / pairs : Weight * this->NumberOfDistances;
  for (const auto& [s, t] : this->SameBranches)
  {
    const bool isTargetMatched = std::find(targetOf.begin(), targetOf.end(), t) != targetOf.end();
    total += targetOf[s] < 0 && !isTargetMatched ? Weight : 0.0;
  }
  for (const auto& [s, t] : this->ForbiddenBranches)
  {
    total += targetOf[s] == t ? Weight : 0.0;
  }
  return total;
}
}
