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
  std::vector<Value> values;
  values.reserve(mesh.Triangles.size());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    this->Centroids[t] = mesh.Centroid(t);
    const Eigen::Vector3d area = mesh.AreaVector(t);
    this->Normals[t] = area.norm() > 0.0 ? Eigen::Vector3d(area.normalized()) : area;
    this->NodeOfTriangle[t] = source.NodeOfVertex[mesh.Triangles[t][0]];
    if (isFindable.empty() || isFindable[t])
    {
      const Eigen::Vector3d& c = this->Centroids[t];
      values.emplace_back(Point(c.x(), c.y(), c.z()), t);
    }
  }
  this->Index = Tree(values.begin(), values.end());
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

std::vector<std::pair<double, int>> SourceSearch::Rank(const Query& query) const
{
  namespace index = boost::geometry::index;
  constexpr unsigned numberOfCandidates = 16;
  const Point point(query.Position.x(), query.Position.y(), query.Position.z());
  // Within a few radii along the skeleton: parts beyond are near in space only by the pose.
  const double reach = 3.0 * query.Radius;
  std::vector<Value> found;
  if (query.Among)
  {
    const auto isAmong = [&](const Value& value) { return (*query.Among)[value.second]; };
    this->Index.query(index::nearest(point, numberOfCandidates) && index::satisfies(isAmong),
      std::back_inserter(found));
  }
  else if (query.Node >= 0)
  {
    const auto isNear = [&](const Value& value)
    {
      const int node = this->NodeOfTriangle[value.second];
      return node < 0 || this->NodeDistance(query.Node, node) <= reach;
    };
    this->Index.query(index::nearest(point, numberOfCandidates) && index::satisfies(isNear),
      std::back_inserter(found));
  }
  if (found.empty())
  {
    this->Index.query(index::nearest(point, numberOfCandidates), std::back_inserter(found));
  }
  std::vector<std::pair<double, int>> costs;
  for (const Value& value : found)
  {
    const int t = value.second;
    const int node = this->NodeOfTriangle[t];
    const double along =
      query.Node >= 0 && node >= 0 ? std::min(this->NodeDistance(query.Node, node), reach) : 0.0;
    costs.emplace_back((this->Centroids[t] - query.Position).squaredNorm() + 0.1 * along * along +
        0.5 * query.Radius * query.Radius * (1.0 - this->Normals[t].dot(query.Normal)),
      t);
  }
  std::sort(costs.begin(), costs.end());
  return costs;
}

int SourceSearch::Find(const Query& query) const
{
  const auto costs = this->Rank(query);
  return costs.empty() ? -1 : costs.front().second;
}

std::vector<std::pair<int, double>> SourceSearch::FindSeveral(const Query& query) const
{
  const auto costs = this->Rank(query);
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

double SourceSearch::Misfit(const Query& query, int triangle, double scale) const
{
  const double squared =
    (this->Centroids[triangle] - query.Position).squaredNorm() / (scale * scale);
  const double turn = 1.0 - this->Normals[triangle].dot(query.Normal);
  return std::min(1.0, squared + 0.5 * turn);
}
}
