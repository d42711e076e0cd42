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
using Entry = std::pair<double, int>; ///< squared distance or cost, triangle
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

void SourceSearch::FindCandidates(
  const Query& query, double squaredReach, bool isAny, Candidates& candidates) const
{
  std::array<Entry, Candidates::MostKnown> nearest;
  int count = 0;
  this->Index.Search(query.Position, squaredReach,
    [&](int triangle, double squared)
    {
      const bool isFull = count == Candidates::MostKnown;
      const Entry entry(squared, triangle);
      const bool isAllowed =
        (!query.Among || (*query.Among)[triangle]) && (isAny || this->IsNear(query, triangle));
      if ((!isFull || entry < nearest.back()) && isAllowed)
      {
        int place = isFull ? count - 1 : count++;
        for (; place > 0 && entry < nearest[place - 1]; --place)
        {
          nearest[place] = nearest[place - 1];
        }
        nearest[place] = entry;
      }
      return count == Candidates::MostKnown ? std::min(squaredReach, nearest.back().first)
                                            : squaredReach;
    });
  for (int i = 0; i < count; ++i)
  {
    candidates.Triangles[i] = nearest[i].second;
  }
  candidates.CountKnown = count;
  candidates.Count = std::min(count, Candidates::Most);
  candidates.Center = query.Position;
  candidates.Radius = count == Candidates::MostKnown ? std::sqrt(nearest.back().first) : Infinity;
}

void SourceSearch::UpdateCandidates(const Query& query, Candidates& candidates) const
{
  if (candidates.CountKnown == 0)
  {
    this->FindCandidates(query, Infinity, query.Node < 0 && !query.Among, candidates);
    if (candidates.CountKnown == 0)
    {
      this->FindCandidates(query, Infinity, true, candidates);
    }
    return;
  }
  std::array<Entry, Candidates::MostKnown> known;
  const auto end = known.begin() + candidates.CountKnown;
  for (int i = 0; i < candidates.CountKnown; ++i)
  {
    const int triangle = candidates.Triangles[i];
    known[i] = { (this->Centroids[triangle] - query.Position).squaredNorm(), triangle };
  }
  const auto last = known.begin() + candidates.Count - 1;
  std::nth_element(known.begin(), last, end);
  // By the triangle inequality.
  const double moved = (query.Position - candidates.Center).norm();
  constexpr double withRounding = 1.0 - 1e-9; // less than what is known to be near
  if (std::sqrt(last->first) < (candidates.Radius - moved) * withRounding)
  {
    for (int i = 0; i < candidates.CountKnown; ++i)
    {
      candidates.Triangles[i] = known[i].second;
    }
    return;
  }
  // All of them are near along the skeleton, or none of the whole source is.
  const bool isAny = !this->IsNear(query, candidates.Triangles.front());
  this->FindCandidates(query, std::max_element(known.begin(), end)->first, isAny, candidates);
}

double SourceSearch::CostOf(const Query& query, int triangle) const
{
  const int node = this->NodeOfTriangle[triangle];
  const double along = query.Node >= 0 && node >= 0
    ? std::min(this->NodeDistance(query.Node, node), Reach(query))
    : 0.0;
  /// A way along the skeleton counts a third of one through space, as branches are matched roughly.
  constexpr double weightAlong = 0.1;
  return (this->Centroids[triangle] - query.Position).squaredNorm() + weightAlong * along * along +
    0.5 * query.Radius * query.Radius * (1.0 - this->Normals[triangle].dot(query.Normal));
}

int SourceSearch::Best(const Query& query, const Candidates& candidates) const
{
  Entry best(Infinity, -1);
  for (int i = 0; i < candidates.Count; ++i)
  {
    const int triangle = candidates.Triangles[i];
    const Entry entry(this->CostOf(query, triangle), triangle);
    best = i == 0 ? entry : std::min(best, entry);
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
  /// Of the limb's radius: triangles that much farther than the best still count.
  constexpr double blend = 0.1;
  const double width = std::max(blend * query.Radius, 1e-300);
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

double SourceSearch::Misfit(const Query& query, int triangle, double scale) const
{
  const double squared =
    (this->Centroids[triangle] - query.Position).squaredNorm() / (scale * scale);
  const double turn = 1.0 - this->Normals[triangle].dot(query.Normal);
  return std::min(1.0, squared + 0.5 * turn);
}
}
