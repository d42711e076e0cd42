// SPDX-License-Identifier: BSD-3-Clause
#include "JunctionCost.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace marrow
{
double StructureCost(std::vector<double> sourceSizes, std::vector<double> targetSizes)
{
  if (sourceSizes.size() < targetSizes.size())
  {
    sourceSizes.swap(targetSizes);
  }
  std::sort(sourceSizes.begin(), sourceSizes.end(), std::greater<double>());
  std::sort(targetSizes.begin(), targetSizes.end(), std::greater<double>());
  double cost = 0.0;
  for (std::size_t i = 0; i < sourceSizes.size(); ++i)
  {
    const double difference = sourceSizes[i] - (i < targetSizes.size() ? targetSizes[i] : 0.0);
    cost += difference * difference;
  }
  return cost;
}

double StructureCost(const FeatureGraph& source, const FeatureGroup& sourceGroup,
  const FeatureGraph& target, const FeatureGroup& targetGroup)
{
  return StructureCost(source.SubSkeletonSizes(sourceGroup, source.OpenDarts(sourceGroup)),
    target.SubSkeletonSizes(targetGroup, target.OpenDarts(targetGroup)));
}

double JunctionCost(const FeatureGraph& source, const FeatureGroup& sourceGroup,
  const FeatureGraph& target, const FeatureGroup& targetGroup)
{
  const double center = std::abs(source.AGD(sourceGroup) - target.AGD(targetGroup));
  const double structure = StructureCost(source, sourceGroup, target, targetGroup);
  return (center + CostEpsilon) * (structure + CostEpsilon);
}

std::vector<FeatureGroup> GroupsFrom(const FeatureGraph& graph, int feature, double mergeDistance,
  int maximumSize, const std::vector<bool>& blocked)
{
  const double longest =
    graph.TotalLength() > 0.0 ? mergeDistance / graph.TotalLength() : mergeDistance;
  std::vector<FeatureGroup> groups{ FeatureGroup{ { feature }, {} } };
  while (static_cast<int>(groups.back().Features.size()) < maximumSize)
  {
    const FeatureGroup& last = groups.back();
    int best = -1;
    for (int dart : graph.OpenDarts(last))
    {
      const int head = graph.Head(dart);
      if (!last.Contains(head) && graph.GetFeatures()[head].IsJunction() && !blocked[head] &&
        graph.Length(dart / 2) <= longest &&
        (best < 0 || graph.Length(dart / 2) < graph.Length(best / 2)))
      {
        best = dart;
      }
    }
    if (best < 0)
    {
      break;
    }
    FeatureGroup next = last;
    const int head = graph.Head(best);
    // Branches as short as that between the same two junctions vanish with it.
    for (int dart : graph.GetFeatures()[head].Darts)
    {
      if (last.Contains(graph.Head(dart)) && graph.Length(dart / 2) <= longest)
      {
        next.Inside.push_back(dart / 2);
      }
    }
    next.Features.push_back(head);
    std::sort(next.Features.begin(), next.Features.end());
    std::sort(next.Inside.begin(), next.Inside.end());
    groups.push_back(next);
  }
  return groups;
}

std::vector<FeatureGroup> JunctionGroups(
  const FeatureGraph& graph, int component, double mergeDistance, int maximumSize)
{
  const std::vector<bool> blocked(graph.NumberOfFeatures(), false);
  std::vector<FeatureGroup> result;
  for (int f = 0; f < graph.NumberOfFeatures(); ++f)
  {
    const auto& feature = graph.GetFeatures()[f];
    if (feature.Component != component || !feature.IsJunction())
    {
      continue;
    }
    for (FeatureGroup& group : GroupsFrom(graph, f, mergeDistance, maximumSize, blocked))
    {
      if (std::find(result.begin(), result.end(), group) == result.end())
      {
        result.push_back(std::move(group));
      }
    }
  }
  std::stable_sort(result.begin(), result.end(),
    [](const FeatureGroup& a, const FeatureGroup& b)
    { return a.Features.size() < b.Features.size(); });
  return result;
}
}
