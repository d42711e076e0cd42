// SPDX-License-Identifier: BSD-3-Clause
#include "FeaturePoints.h"

#include "SegmentBoundary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow::bench
{
namespace
{
constexpr double LargestTerminalDistance = 0.1;
/// Of the mean distance between features: mirror images differ by less, front and back by more.
constexpr double LargestMirrorDifference = 0.05;
}

TerminalFeatures FindTerminalFeatures(const PreparedMesh& mesh)
{
  TerminalFeatures result;
  const std::size_t size = mesh.Features.size();
  result.OfNode.resize(mesh.PlainSkeleton.NumberOfNodes());
  result.Distances.resize(size * size);
  std::vector<int> nearest(size, -1);
  std::vector<double> distanceToNearest(size, std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < size; ++k)
  {
    const std::vector<double> distances = EdgeDistances(mesh.Mesh, { mesh.Features[k] });
    for (std::size_t l = 0; l < size; ++l)
    {
      result.Distances[k * size + l] = distances[mesh.Features[l]];
    }
    for (int node = 0; node < mesh.PlainSkeleton.NumberOfNodes(); ++node)
    {
      if (mesh.PlainSkeleton.TypeOf(node) == NodeType::Terminal)
      {
        for (const int vertex : mesh.PlainSkeleton.Graph[node].Vertices)
        {
          if (distances[vertex] < distanceToNearest[k])
          {
            distanceToNearest[k] = distances[vertex];
            nearest[k] = node;
          }
        }
      }
    }
  }
  if (size > 0)
  {
    const double largest = *std::max_element(result.Distances.begin(), result.Distances.end());
    for (std::size_t k = 0; k < size; ++k)
    {
      if (nearest[k] >= 0 && distanceToNearest[k] < LargestTerminalDistance * largest)
      {
        result.OfNode[nearest[k]].push_back(static_cast<int>(k));
      }
    }
    for (double& distance : result.Distances)
    {
      distance /= largest;
    }
  }
  return result;
}

std::vector<int> FindMirrorFeatures(const std::vector<TerminalFeatures>& meshes)
{
  const std::size_t squared = meshes.empty() ? 0 : meshes.front().Distances.size();
  const int size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(squared))));
  // Per feature its distances to all, from near to far, on the mean of the meshes.
  std::vector<std::vector<double>> profiles(size, std::vector<double>(size, 0.0));
  double mean = 0.0;
  for (const TerminalFeatures& mesh : meshes)
  {
    if (mesh.Distances.size() != squared)
    {
      return {};
    }
    for (int k = 0; k < size; ++k)
    {
      std::vector<double> sorted(
        mesh.Distances.begin() + k * size, mesh.Distances.begin() + (k + 1) * size);
      std::sort(sorted.begin(), sorted.end());
      for (int l = 0; l < size; ++l)
      {
        profiles[k][l] += sorted[l] / meshes.size();
        mean += sorted[l] / meshes.size() / squared;
      }
    }
  }
  const auto difference = [&](int a, int b)
  {
    double sum = 0.0;
    for (int l = 0; l < size; ++l)
    {
      sum += std::abs(profiles[a][l] - profiles[b][l]) / size;
    }
    return sum;
  };
  std::vector<int> closest(size, -1);
  for (int k = 0; k < size; ++k)
  {
    double least = LargestMirrorDifference * mean;
    for (int l = 0; l < size; ++l)
    {
      if (l != k && difference(k, l) < least)
      {
        least = difference(k, l);
        closest[k] = l;
      }
    }
  }
  std::vector<int> mirror(size, -1);
  for (int k = 0; k < size; ++k)
  {
    if (closest[k] >= 0 && closest[closest[k]] == k)
    {
      mirror[k] = closest[k];
    }
  }
  return mirror;
}
}
