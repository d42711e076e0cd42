// SPDX-License-Identifier: BSD-3-Clause
#include "FeaturePaths.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace marrow
{
namespace
{
constexpr double Far = std::numeric_limits<double>::infinity();
}

FeaturePaths::FeaturePaths(const FeatureGraph& graph)
  : Skeleton(graph)
{
  const auto weight = [&](int feature) { return graph.Length(graph.GetFeatures()[feature].Darts); };
  this->Features.resize(graph.NumberOfFeatures());
  std::iota(this->Features.begin(), this->Features.end(), 0);
  if (this->Size() > MaximumFeatures)
  {
    std::stable_sort(this->Features.begin(), this->Features.end(),
      [&](int a, int b) { return weight(a) > weight(b); });
    this->Features.resize(MaximumFeatures);
    std::sort(this->Features.begin(), this->Features.end());
  }
  this->Lengths.assign(this->Size() * this->Size(), Far);
  this->Insides.assign(this->Size() * this->Size(), 0);
  this->Paths.resize(this->Size() * this->Size());
  for (int from = 0; from < this->Size(); ++from)
  {
    this->FindPathsFrom(from);
  }
  double longest = 0.0;
  for (const double length : this->Lengths)
  {
    longest = length < Far ? std::max(longest, length) : longest;
  }
  for (double& length : this->Lengths)
  {
    length /= longest > 0.0 ? longest : 1.0;
  }
  this->FindNears();
}

void FeaturePaths::FindPathsFrom(int from)
{
  const FeatureGraph& graph = this->Skeleton;
  const FeatureGraph::ShortestPaths shortest = graph.ShortestPathsFrom(this->Features[from], false);
  std::vector<int> number(graph.NumberOfFeatures(), -1);
  for (int i = 0; i < this->Size(); ++i)
  {
    number[this->Features[i]] = i;
  }
  for (int to = 0; to < this->Size(); ++to)
  {
    const int entry = from * this->Size() + to;
    this->Lengths[entry] = shortest.Length[this->Features[to]];
    std::vector<int>& path = this->Paths[entry];
    for (int dart = shortest.Arrival[this->Features[to]]; dart >= 0;
         dart = shortest.Arrival[graph.Origin(dart)])
    {
      path.push_back(dart);
      const int inside = number[graph.Origin(dart)];
      if (inside >= 0 && inside != from)
      {
        this->Insides[entry] |= Mask(1) << inside;
      }
    }
    std::reverse(path.begin(), path.end());
  }
}

void FeaturePaths::FindNears()
{
  this->Nears = this->Insides;
  for (int a = 0; a < this->Size(); ++a)
  {
    for (int b = 0; b < this->Size(); ++b)
    {
      for (int middle = 0; middle < this->Size(); ++middle)
      {
        // Between components, the difference is no number.
        const double off =
          0.5 * (this->Length(a, middle) + this->Length(middle, b) - this->Length(a, b));
        if (off <= NearPath)
        {
          this->Nears[a * this->Size() + b] |= Mask(1) << middle;
        }
      }
    }
  }
}
}
