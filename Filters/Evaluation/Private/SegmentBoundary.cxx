// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentBoundary.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace marrow
{
namespace
{
/// Sums over one boundary of the distances to the other.
struct DistanceSums
{
  double Distance = 0.0;
  double Vertices = 0.0;
  double WeightedDistance = 0.0;
  double Length = 0.0;

  void Add(const TriangleMesh& mesh, const SegmentBoundary& boundary,
    const std::vector<double>& distanceToOther)
  {
    for (const int vertex : boundary.Vertices)
    {
      if (std::isfinite(distanceToOther[vertex]))
      {
        this->Distance += distanceToOther[vertex];
        this->Vertices += 1.0;
      }
    }
    for (const int h : boundary.HalfEdges)
    {
      const int from = mesh.From(h);
      const int to = mesh.To(h);
      const double mean = 0.5 * (distanceToOther[from] + distanceToOther[to]);
      if (std::isfinite(mean))
      {
        const double length = (mesh.Points[to] - mesh.Points[from]).norm();
        this->WeightedDistance += length * mean;
        this->Length += length;
      }
    }
  }
};
}

SegmentBoundary::SegmentBoundary(const TriangleMesh& mesh, const std::vector<int>& segments)
{
  std::vector<char> onBoundary(mesh.NumberOfVertices(), 0);
  for (int h = 0; h < static_cast<int>(mesh.Opposite.size()); ++h)
  {
    const int opposite = mesh.Opposite[h];
    if (opposite > h &&
      segments[TriangleMesh::TriangleOf(h)] != segments[TriangleMesh::TriangleOf(opposite)])
    {
      this->HalfEdges.push_back(h);
      onBoundary[mesh.From(h)] = onBoundary[mesh.To(h)] = 1;
    }
  }
  for (int vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    if (onBoundary[vertex])
    {
      this->Vertices.push_back(vertex);
    }
  }
}

std::vector<double> EdgeDistances(const TriangleMesh& mesh, const std::vector<int>& sources)
{
  std::vector<double> distances(mesh.NumberOfVertices(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const int source : sources)
  {
    distances[source] = 0.0;
    queue.emplace(0.0, source);
  }
  while (!queue.empty())
  {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distances[vertex])
    {
      continue; // reached on a shorter path meanwhile
    }
    const Eigen::Vector3d& point = mesh.Points[vertex];
    mesh.ForEachNeighbor(vertex,
      [&, from = distance](int neighbor)
      {
        const double candidate = from + (mesh.Points[neighbor] - point).norm();
        if (candidate < distances[neighbor])
        {
          distances[neighbor] = candidate;
          queue.emplace(candidate, neighbor);
        }
      });
  }
  return distances;
}

BoundaryDistances MeasureBoundaryDistances(
  const TriangleMesh& mesh, const std::vector<int>& segments, const std::vector<int>& reference)
{
  const SegmentBoundary boundary(mesh, segments);
  const SegmentBoundary referenceBoundary(mesh, reference);
  if (boundary.Vertices.empty() && referenceBoundary.Vertices.empty())
  {
    return {};
  }
  DistanceSums sums;
  sums.Add(mesh, boundary, EdgeDistances(mesh, referenceBoundary.Vertices));
  sums.Add(mesh, referenceBoundary, EdgeDistances(mesh, boundary.Vertices));
  // 0/0 is NaN, as promised.
  return { sums.Distance / sums.Vertices, sums.WeightedDistance / sums.Length };
}
}
