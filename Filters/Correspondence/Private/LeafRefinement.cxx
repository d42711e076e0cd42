// SPDX-License-Identifier: BSD-3-Clause
#include "LeafRefinement.h"

#include <algorithm>
#include <functional>

namespace marrow
{
namespace
{
using Assignment = GlobalCost::Assignment;

/// How much the intrinsic cost may rise to get left and right as they are; less than any real difference.
constexpr double SymmetryTolerance = 0.01;
/// Pairs of twins that are exchanged in all combinations; their number doubles with each.
constexpr std::size_t MaximumSymmetries = 5;

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

Assignment DescendBy(
  const std::function<double(const Assignment&)>& cost, int targets, Assignment current)
{
  /// A smaller gain is rounding.
  constexpr double least = 1e-9;
  /// Only a bound: every step lowers the cost.
  constexpr int maximumSteps = 100;
  double currentCost = cost(current);
  for (int step = 0; step < maximumSteps; ++step)
  {
    Assignment best;
    double bestCost = currentCost - least;
    ForEachNeighbor(current, targets,
      [&](const Assignment& changed)
      {
        const double value = cost(changed);
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

/// Tries all combinations of the exchanges that leave the intrinsic cost nearly as it is.
Assignment ChooseHands(const GlobalCost& cost, const Assignment& start)
{
  const double intrinsic = cost.Intrinsic(start);
  std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> exchanges;
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    for (std::size_t k = i + 1; k < start.size(); ++k)
    {
      if (start[i] >= 0 && start[k] >= 0)
      {
        Assignment changed = start;
        std::swap(changed[i], changed[k]);
        const double rise = cost.Intrinsic(changed) - intrinsic;
        if (rise <= SymmetryTolerance)
        {
          exchanges.push_back({ rise, { i, k } });
        }
      }
    }
  }
  std::stable_sort(exchanges.begin(), exchanges.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  if (exchanges.size() > MaximumSymmetries)
  {
    exchanges.resize(MaximumSymmetries);
  }
  Assignment best = start;
  double bestCost = cost.Total(start);
  for (unsigned combination = 1; combination < 1u << exchanges.size(); ++combination)
  {
    Assignment changed = start;
    for (std::size_t e = 0; e < exchanges.size(); ++e)
    {
      if ((combination >> e & 1u) != 0)
      {
        std::swap(changed[exchanges[e].second.first], changed[exchanges[e].second.second]);
      }
    }
    const double value = cost.Total(changed);
    if (value < bestCost)
    {
      bestCost = value;
      best = changed;
    }
  }
  return best;
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
  const auto addOnce = [](std::vector<Assignment>& list, Assignment assignment)
  {
    if (std::find(list.begin(), list.end(), assignment) == list.end())
    {
      list.push_back(std::move(assignment));
    }
  };
  std::vector<Assignment> low;
  for (const Assignment& start : starts)
  {
    addOnce(
      low, DescendBy([&](const Assignment& a) { return cost.Intrinsic(a); }, target.Size(), start));
  }
  std::vector<Assignment> result;
  for (const Assignment& assignment : low)
  {
    addOnce(result, ChooseHands(cost, assignment));
  }
  return result;
}
}
