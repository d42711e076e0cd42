// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPaths.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace marrow
{
namespace
{
using Entry = std::pair<double, int>;
using Heap = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

PathField DistanceField(const TriangleMesh& mesh, const std::vector<int>& seeds, double limit)
{
  PathField field;
  field.Distance.assign(mesh.NumberOfVertices(), Infinity);
  field.Origin.assign(mesh.NumberOfVertices(), -1);
  field.Previous.assign(mesh.NumberOfVertices(), -1);
  Heap heap;
  for (int seed : seeds)
  {
    field.Distance[seed] = 0.0;
    field.Origin[seed] = seed;
    heap.push({ 0.0, seed });
  }
  while (!heap.empty())
  {
    const auto [distance, vertex] = heap.top();
    heap.pop();
    if (distance > field.Distance[vertex])
    {
      continue;
    }
    const int from = vertex;
    const double reached = distance;
    mesh.ForEachNeighbor(from,
      [&](int to)
      {
        const double next = reached + (mesh.Points[to] - mesh.Points[from]).norm();
        if (next < field.Distance[to] && next <= limit)
        {
          field.Distance[to] = next;
          field.Origin[to] = field.Origin[from];
          field.Previous[to] = from;
          heap.push({ next, to });
        }
      });
  }
  return field;
}

PathFinder::PathFinder(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Distance(mesh.NumberOfVertices(), Infinity)
  , Previous(mesh.NumberOfVertices(), -1)
{
}

std::vector<int> PathFinder::Find(
  const std::vector<int>& starts, const std::function<bool(int)>& isGoal, const Cost& cost)
{
  for (int vertex : this->Touched)
  {
    this->Distance[vertex] = Infinity;
    this->Previous[vertex] = -1;
  }
  this->Touched.clear();

  Heap heap;
  for (int start : starts)
  {
    this->Distance[start] = 0.0;
    this->Touched.push_back(start);
    heap.push({ 0.0, start });
  }
  while (!heap.empty())
  {
    const auto [distance, vertex] = heap.top();
    heap.pop();
    if (distance > this->Distance[vertex])
    {
      continue;
    }
    if (isGoal(vertex))
    {
      std::vector<int> path;
      for (int v = vertex; v >= 0; v = this->Previous[v])
      {
        path.push_back(v);
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    const int from = vertex;
    const double reached = distance;
    this->Mesh.ForEachNeighbor(from,
      [&](int to)
      {
        const double next = reached + cost(from, to);
        if (next < this->Distance[to])
        {
          if (this->Distance[to] == Infinity)
          {
            this->Touched.push_back(to);
          }
          this->Distance[to] = next;
          this->Previous[to] = from;
          heap.push({ next, to });
        }
      });
  }
  return {};
}
}
