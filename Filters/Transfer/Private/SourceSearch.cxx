// SPDX-License-Identifier: BSD-3-Clause
#include "SourceSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace marrow
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

SourceSearch::SourceSearch(const AnalyzedMesh& source, const std::vector<bool>& isFindable)
{
  this->ComputeNodeDistances(source.Skeleton);
  const TriangleMesh& mesh = source.Mesh;
  this->Centroids.resize(mesh.NumberOfTriangles());
  this->Normals.resize(mesh.NumberOfTriangles());
  this->NodeOfTriangle.resize(mesh.NumberOfTriangles());
  std::vector<int> findable;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    this->Centroids[t] = mesh.Centroid(t);
    const Eigen::Vector3d area = mesh.AreaVector(t);
    this->Normals[t] = area.norm() > 0.0 ? Eigen::Vector3d(area.normalized()) : area;
    this->NodeOfTriangle[t] = source.NodeOfVertex[mesh.Triangles[t][0]];
    if (isFindable.empty() || isFindable[t])
    {
      findable.push_back(t);
    }
  }
  this->Index = PointTree(this->Centroids, std::move(findable));
}

void SourceSearch::ComputeNodeDistances(const Skeleton& skeleton)
{
  this->NumberOfNodes = skeleton.NumberOfNodes();
  this->NodeDistances.assign(
    static_cast<std::size_t>(this->NumberOfNodes) * this->NumberOfNodes, Infinity);
  using Entry = std::pair<double, int>;
  for (int start = 0; start < this->NumberOfNodes; ++start)
  {
    double* distance =
      this->NodeDistances.data() + static_cast<std::size_t>(start) * this->NumberOfNodes;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
    distance[start] = 0.0;
    heap.push({ 0.0, start });
    while (!heap.empty())
    {
      const auto [reached, node] = heap.top();
      heap.pop();
      if (reached > distance[node])
      {
        continue;
      }
      for (auto [e, end] = boost::out_edges(node, skeleton.Graph); e != end; ++e)
      {
        const int next = static_cast<int>(boost::target(*e, skeleton.Graph));
        const double sum =
          reached + (skeleton.Graph[next].Position - skeleton.Graph[node].Position).norm();
        if (sum < distance[next])
        {
          distance[next] = sum;
          heap.push({ sum, next });
        }
      }
    }
  }
}

void SourceSearch::UpdateCandidates(const Query& query, Candidates& candidates) const
{
  using Entry = std::pair<double, int>;
  std::array<Entry, Candidates::Most> nearest;
  int count = 0;
  const auto search = [&](double squaredReach, bool isAny)
  {
    count = 0;
    this->Index.Search(query.Position, squaredReach,
      [&](int triangle, double squared)
      {
        const bool isFull = count == Candidates::Most;
        const Entry entry(squared, triangle);
        if ((!isFull || entry < nearest.back()) && (isAny || this->IsNear(query, triangle)))
        {
          int place = isFull ? count - 1 : count;
          for (; place > 0 && entry < nearest[place - 1]; --place)
          {
            nearest[place] = nearest[place - 1];
          }
          nearest[place] = entry;
          count = std::min(count + 1, Candidates::Most);
        }
        return count == Candidates::Most ? std::min(squaredReach, nearest.back().first)
                                         : squaredReach;
      });
  };

  double squaredReach = Infinity;
  bool isAny = false;
  if (candidates.Count > 0)
  {
    // All are near along the skeleton, or none in the whole source is.
    isAny = !this->IsNear(query, candidates.Triangles.front());
  }
  if (candidates.Count == Candidates::Most)
  {
    squaredReach = 0.0;
    for (const int triangle : candidates.Triangles)
    {
      squaredReach =
        std::max(squaredReach, (this->Centroids[triangle] - query.Position).squaredNorm());
    }
  }
  search(squaredReach, isAny);
  if (count == 0 && !isAny)
  {
    search(Infinity, true);
  }
  candidates.Count = count;
  for (int i = 0; i < count; ++i)
  {
    candidates.Triangles[i] = nearest[i].second;
  }
}

double SourceSearch::CostOf(const Query& query, int triangle) const
{
  const int node = this->NodeOfTriangle[triangle];
  const double along = query.Node >= 0 && node >= 0
    ? std::min(this->NodeDistance(query.Node, node), Reach(query))
    : 0.0;
  return (this->Centroids[triangle] - query.Position).squaredNorm() + 0.1 * along * along +
    0.5 * query.Radius * query.Radius * (1.0 - this->Normals[triangle].dot(query.Normal));
}

int SourceSearch::Best(const Query& query, const Candidates& candidates) const
{
  std::pair<double, int> best(Infinity, -1);
  for (int i = 0; i < candidates.Count; ++i)
  {
    const int triangle = candidates.Triangles[i];
    best = std::min(best, { this->CostOf(query, triangle), triangle });
  }
  return best.second;
}

std::vector<std::pair<int, double>> SourceSearch::Weigh(
  const Query& query, const Candidates& candidates) const
{
  std::vector<std::pair<double, int>> costs;
  for (int i = 0; i < candidates.Count; ++i)
  {
    const int triangle = candidates.Triangles[i];
    costs.emplace_back(this->CostOf(query, triangle), triangle);
  }
  std::sort(costs.begin(), costs.end());
  const double width = std::max(0.1 * query.Radius, 1e-300);
  std::vector<std::pair<int, double>> found;
  double total = 0.0;
  for (const auto& [cost, t] : costs)
  {
    found.emplace_back(t, std::exp(-(cost - costs.front().first) / (width * width)));
    total += found.back().second;
  }
  for (auto& entry : found)
  {
    entry.second /= total;
  }
  return found;
}
}
