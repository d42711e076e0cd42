// SPDX-License-Identifier: BSD-3-Clause
#include "BeamSearch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
using Assignment = GlobalCost::Assignment;
using Rated = std::pair<double, Assignment>;

/// Ways that go on. With 30 some were missed on figures that 60 finds; 100 and 400 find no others.
constexpr int Width = 60;
/// Of skeletons with many terminals fewer go on: work grows with the fifth power of their number.
constexpr int MostEvaluations = 10000;
/// Of the source's terminals, by weight; from 0.15 to 0.35 the results on real meshes are the same.
constexpr double LeastDifference = 0.25;
/// More would be tried in vain.
constexpr std::size_t MostOthers = 4;
/// What costs so much more than the cheapest known one is hardly ever right.
constexpr double MostExcess = 0.06;

std::vector<int> ByWeight(const TerminalPaths& paths)
{
  std::vector<int> order(paths.Size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return paths.Weight(a) > paths.Weight(b); });
  return order;
}

/// With one more terminal of the source matched, in all ways that are left.
void Extend(const GlobalCost& cost, const Assignment& assignment, int terminal, int targets,
  std::vector<Rated>& extended)
{
  for (int j = -1; j < targets; ++j)
  {
    if (j >= 0 && std::find(assignment.begin(), assignment.end(), j) != assignment.end())
    {
      continue;
    }
    Assignment next = assignment;
    next[terminal] = j;
    const double ofNext = cost.Intrinsic(next);
    extended.emplace_back(ofNext, std::move(next));
  }
}

double Difference(const TerminalPaths& source, const Assignment& a, const Assignment& b)
{
  double difference = 0.0;
  for (int i = 0; i < source.Size(); ++i)
  {
    difference += a[i] != b[i] ? source.Weight(i) : 0.0;
  }
  return difference;
}
}

std::vector<Assignment> FindOthers(const GlobalCost& cost, const TerminalPaths& source,
  const TerminalPaths& target, std::vector<Assignment> known)
{
  std::vector<Assignment> others;
  const int sources = source.Size();
  const int targets = target.Size();
  if (sources == 0 || targets == 0)
  {
    return others;
  }
  const std::size_t width = std::clamp(MostEvaluations / (sources * (targets + 1)), 1, Width);
  std::vector<Rated> beam{ { 0.0, Assignment(sources, -1) } };
  for (const int terminal : ByWeight(source))
  {
    std::vector<Rated> extended;
    for (const Rated& way : beam)
    {
      Extend(cost, way.second, terminal, targets, extended);
    }
    std::sort(extended.begin(), extended.end());
    extended.resize(std::min(extended.size(), width));
    beam = std::move(extended);
  }
  for (Rated& way : beam)
  {
    way.first = cost.Total(way.second);
  }
  std::sort(beam.begin(), beam.end());

  double least = beam.front().first;
  for (const Assignment& assignment : known)
  {
    least = std::min(least, cost.Total(assignment));
  }
  for (const Rated& way : beam)
  {
    if (others.size() == MostOthers || way.first > least + MostExcess)
    {
      break;
    }
    if (std::none_of(known.begin(), known.end(),
          [&](const Assignment& other)
          { return Difference(source, way.second, other) < LeastDifference; }))
    {
      known.push_back(way.second);
      others.push_back(way.second);
    }
  }
  return others;
}
}
