// SPDX-License-Identifier: BSD-3-Clause
#include "BranchClusters.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
std::vector<int> ClusterBranches(
  const FeatureGraph& graph, const std::vector<int>& darts, double distance)
{
  const int count = static_cast<int>(darts.size());
  std::vector<std::vector<double>> distances(count, std::vector<double>(count, 0.0));
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      const auto& a = graph.Descriptor(darts[i]);
      distances[i][j] =
        ProfileDistance(a, graph.Descriptor(darts[j])) * std::sqrt(static_cast<double>(a.size()));
    }
  }
  std::vector<std::vector<int>> sets;
  for (int i = 0; i < count; ++i)
  {
    sets.push_back({ i });
  }
  for (;;)
  {
    double least = distance;
    int first = -1;
    int second = -1;
    for (int i = 0; i < static_cast<int>(sets.size()); ++i)
    {
      for (int j = i + 1; j < static_cast<int>(sets.size()); ++j)
      {
        double widest = 0.0;
        for (int a : sets[i])
        {
          for (int b : sets[j])
          {
            widest = std::max(widest, distances[a][b]);
          }
        }
        if (widest < least || (first < 0 && widest == least))
        {
          least = widest;
          first = i;
          second = j;
        }
      }
    }
    if (first < 0)
    {
      break;
    }
    sets[first].insert(sets[first].end(), sets[second].begin(), sets[second].end());
    sets.erase(sets.begin() + second);
  }
  std::vector<int> clusters(count, -1);
  int next = 0;
  for (const auto& set : sets)
  {
    if (set.size() > 1)
    {
      for (int i : set)
      {
        clusters[i] = next;
      }
      ++next;
    }
  }
  return clusters;
}

int NumberOfClusters(const std::vector<int>& clusters)
{
  return clusters.empty() ? 0 : 1 + *std::max_element(clusters.begin(), clusters.end());
}
}
