// SPDX-License-Identifier: BSD-3-Clause
#include "LeafRefinement.h"

#include <algorithm>
#include <functional>

namespace marrow
{
namespace
{
using Assignment = GlobalCost::Assignment;

/// Calls visit(changed) for everything one step away.
void ForEachNeighbor(
  const Assignment& current, int targets, const std::function<void(const Assignment&)>& visit)
{
  std::vector<int> sourceOf(targets, -1);
  for (std::size_t i = 0; i < current.size(); ++i)
  {
    if (current[i] >= 0)
    {
      sourceOf[current[i]] = static_cast<int>(i);
    }
  }
  for (std::size_t i = 0; i < current.size(); ++i)
  {
    for (int j = -1; j < targets; ++j)
    {
      if (j == current[i])
      {
        continue;
      }
      Assignment changed = current;
      const int owner = j >= 0 ? sourceOf[j] : -1;
      changed[i] = j;
      if (owner >= 0)
      {
        changed[owner] = -1;
      }
      visit(changed);
      if (owner >= 0 && current[i] >= 0)
      {
        changed[owner] = current[i];
        visit(changed);
      }
    }
  }
}

Assignment DescendFrom(const GlobalCost& cost, int targets, Assignment current)
{
  /// A smaller gain is rounding.
  constexpr double least = 1e-9;
  /// Only a bound: every step lowers the cost.
  constexpr int maximumSteps = 100;
  double currentCost = cost.Intrinsic(current);
  for (int step = 0; step < maximumSteps; ++step)
  {
    Assignment best;
    double bestCost = currentCost - least;
    ForEachNeighbor(current, targets,
      [&](const Assignment& changed)
      {
        const double value = cost.Intrinsic(changed);
        if (value < bestCost)
        {
          bestCost = value;
          best = changed;
        }
      });
    if (best.empty())
    {
      break;
    }
    current = best;
    currentCost = bestCost;
  }
  return current;
}
}

Assignment TerminalAssignment(
  const TerminalPaths& source, const TerminalPaths& target, const FeatureCorrespondence& leaf)
{
  Assignment result(source.Size(), -1);
  for (const MatchedNodes& nodes : leaf.Nodes)
  {
    const int s = source.TerminalAt(nodes.Source.Features.front());
    const int t = target.TerminalAt(nodes.Target.Features.front());
    if (s >= 0 && t >= 0)
    {
      result[s] = t;
    }
  }
  return result;
}

std::vector<Assignment> Descend(
  const GlobalCost& cost, const TerminalPaths& target, const std::vector<Assignment>& starts)
{
  std::vector<Assignment> result;
  for (const Assignment& start : starts)
  {
    Assignment end = DescendFrom(cost, target.Size(), start);
    if (std::find(result.begin(), result.end(), end) == result.end())
    {
      result.push_back(std::move(end));
    }
  }
  return result;
}
}
