// SPDX-License-Identifier: BSD-3-Clause
#include "HoleFilling.h"

#include "Constants.h"
#include "FanSeparation.h"
#include "MeshCheck.h"
#include "PolygonTriangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <unordered_map>
#include <utility>

namespace marrow
{
namespace
{
/// Half way between a tube's collar, 1, and a plane's, 2, in units of P r.
constexpr double LeastCollar = 1.5;

using Loop = std::vector<int>; // half-edges of the border, each followed by the next

std::vector<Loop> BorderLoops(const TriangleMesh& mesh)
{
  std::vector<Loop> loops;
  std::vector<char> seen(mesh.Opposite.size(), 0);
  for (int h = 0; h < 3 * mesh.NumberOfTriangles(); ++h)
  {
    if (mesh.Opposite[h] >= 0 || seen[h])
    {
      continue;
    }
    loops.emplace_back();
    for (int walk = h; !seen[walk]; walk = mesh.Outgoing[mesh.To(walk)])
    {
      seen[walk] = 1;
      loops.back().push_back(walk);
    }
  }
  return loops;
}

/// Over the middles of the edges: a border along triangles zigzags, and is no longer for that.
double Perimeter(const TriangleMesh& mesh, const Loop& loop)
{
  auto middle = [&](int h) -> Eigen::Vector3d
  { return 0.5 * (mesh.Points[mesh.From(h)] + mesh.Points[mesh.To(h)]); };
  double perimeter = 0.0;
  Eigen::Vector3d last = middle(loop.back());
  for (int h : loop)
  {
    const Eigen::Vector3d next = middle(h);
    perimeter += (next - last).norm();
    last = next;
  }
  return perimeter;
}

/// The share of a triangle where a linear function with these values at its corners is below `limit`.
double ShareBelow(std::array<double, 3> values, double limit)
{
  std::sort(values.begin(), values.end());
  const auto& [low, middle, high] = values;
  if (limit >= high)
  {
    return 1.0;
  }
  if (limit <= low)
  {
    return 0.0;
  }
  return limit <= middle ? (limit - low) * (limit - low) / ((middle - low) * (high - low))
                         : 1.0 - (high - limit) * (high - limit) / ((high - low) * (high - middle));
}

/// The area of the surface within `reach` of the loop, along edges.
double CollarArea(const TriangleMesh& mesh, const Loop& loop, double reach)
{
  std::unordered_map<int, double> distance;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (int h : loop)
  {
    distance[mesh.From(h)] = 0.0;
    queue.push({ 0.0, mesh.From(h) });
  }
  std::unordered_map<int, std::array<double, 3>> collar; // triangles that the collar reaches into
  while (!queue.empty())
  {
    const auto [far, vertex] = queue.top();
    queue.pop();
    if (far > distance[vertex])
    {
      continue;
    }
    mesh.ForEachOutgoing(vertex, [&](int h) { collar[h / 3] = {}; });
    mesh.ForEachNeighbor(vertex,
      [&, from = vertex, at = far](int neighbor)
      {
        const double length = at + (mesh.Points[neighbor] - mesh.Points[from]).norm();
        const auto found = distance.find(neighbor);
        if (found == distance.end() || length < found->second)
        {
          distance[neighbor] = length;
          if (length < reach)
          {
            queue.push({ length, neighbor });
          }
        }
      });
  }
  double area = 0.0;
  for (auto& [triangle, values] : collar)
  {
    for (int k = 0; k < 3; ++k)
    {
      values[k] = distance.at(mesh.Triangles[triangle][k]);
    }
    area += ShareBelow(values, reach) * mesh.Area(triangle);
  }
  return area;
}

void Fill(MendedMesh& mesh, const Loop& loop)
{
  TriangleMesh& triangles = mesh.Mesh;
  // Against the border's direction, so that the new triangles agree with those around the hole.
  const int size = static_cast<int>(loop.size());
  std::vector<Eigen::Vector3d> corners;
  std::vector<int> vertices;
  for (int i = size; i-- > 0;)
  {
    vertices.push_back(triangles.From(loop[i]));
    corners.push_back(triangles.Points[vertices.back()]);
  }
  std::map<std::pair<int, int>, int> diagonals;
  for (const auto& corner : TriangulatePolygon(corners))
  {
    const int first = 3 * triangles.NumberOfTriangles();
    triangles.Triangles.push_back(
      { vertices[corner[0]], vertices[corner[1]], vertices[corner[2]] });
    mesh.CellOfTriangle.push_back(-1);
    triangles.Opposite.insert(triangles.Opposite.end(), { -1, -1, -1 });
    for (int k = 0; k < 3; ++k)
    {
      const int from = corner[k];
      const int to = corner[(k + 1) % 3];
      int partner = -1;
      if (to == (from + 1) % size)
      {
        partner = loop[(2 * size - 2 - from) % size];
      }
      else if (const auto found = diagonals.find({ to, from }); found != diagonals.end())
      {
        partner = found->second;
      }
      else
      {
        diagonals[{ from, to }] = first + k;
        continue;
      }
      triangles.Opposite[first + k] = partner;
      triangles.Opposite[partner] = first + k;
    }
  }
}
}

int FillHoles(MendedMesh& mesh)
{
  const std::vector<Loop> loops = BorderLoops(mesh.Mesh);
  if (loops.empty())
  {
    return 0;
  }
  int numberOfParts = 0;
  const std::vector<int> part = TriangleComponents(mesh.Mesh, numberOfParts);
  std::vector<double> partArea(numberOfParts, 0.0);
  for (int t = 0; t < mesh.Mesh.NumberOfTriangles(); ++t)
  {
    partArea[part[t]] += mesh.Mesh.Area(t);
  }
  std::vector<const Loop*> small;
  for (const Loop& loop : loops)
  {
    const double perimeter = Perimeter(mesh.Mesh, loop);
    const double reach = perimeter / Pi;
    const double leastArea = LeastCollar * perimeter * reach;
    if (loop.size() > 2 && leastArea < partArea[part[loop.front() / 3]] &&
      CollarArea(mesh.Mesh, loop, reach) > leastArea)
    {
      small.push_back(&loop);
    }
  }
  for (const Loop* loop : small)
  {
    Fill(mesh, *loop);
  }
  if (!small.empty())
  {
    SeparateFans(mesh);
  }
  return static_cast<int>(small.size());
}
}
