// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseMesh.h"

#include "VertexGraph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace marrow
{
namespace
{
/// Enough that every finger has some; more take longer and choose no better.
constexpr int NumberOfSamples = 1000;
constexpr int NumberOfPatches = 128;

struct Cells
{
  std::vector<int> Samples;
  std::vector<int> CellOfVertex;  ///< -1 for vertices without triangles
  std::vector<int> PatchOfVertex; ///< cells of the first samples alone
};

/// Samples each of which is as far from those before as any vertex is, along the edges.
Cells FarthestPointCells(const TriangleMesh& mesh)
{
  using Entry = std::pair<double, int>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const int n = mesh.NumberOfVertices();
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : mesh.Points)
  {
    center += point / n;
  }
  const VertexGraph graph(mesh);
  Cells cells;
  cells.CellOfVertex.assign(n, -1);
  std::vector<double> distance(n, infinity);
  // Far vertices first, of those not reached yet the outermost. An entry may be out of date, but distances
  // only fall: one that comes up too early goes back to where it belongs.
  std::priority_queue<std::tuple<double, double, int>> far;
  for (int v = 0; v < n; ++v)
  {
    if (mesh.Outgoing[v] >= 0)
    {
      far.push({ infinity, (mesh.Points[v] - center).squaredNorm(), v });
    }
  }
  while (!far.empty() && static_cast<int>(cells.Samples.size()) < NumberOfSamples)
  {
    const double away = std::get<0>(far.top());
    const int start = std::get<2>(far.top());
    far.pop();
    if (away != distance[start])
    {
      far.push({ distance[start], 0.0, start });
      continue;
    }
    if (away == 0.0)
    {
      break;
    }
    const int cell = static_cast<int>(cells.Samples.size());
    cells.Samples.push_back(start);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> near;
    distance[start] = 0.0;
    near.push({ 0.0, start });
    while (!near.empty())
    {
      const auto [reached, v] = near.top();
      near.pop();
      if (reached > distance[v])
      {
        continue;
      }
      cells.CellOfVertex[v] = cell;
      graph.ForEachEdge(v,
        [&, base = reached](int next, double length)
        {
          const double sum = base + length;
          if (sum < distance[next])
          {
            distance[next] = sum;
            near.push({ sum, next });
          }
        });
    }
    if (static_cast<int>(cells.Samples.size()) <= NumberOfPatches)
    {
      cells.PatchOfVertex = cells.CellOfVertex;
    }
  }
  return cells;
}
}

CoarseMesh Coarsen(const AnalyzedMesh& fine)
{
  const TriangleMesh& mesh = fine.Mesh;
  const Cells cells = FarthestPointCells(mesh);
  const int n = static_cast<int>(cells.Samples.size());
  const std::vector<double> areas = mesh.VertexAreas();
  CoarseMesh coarse;
  AnalyzedMesh& side = coarse.Side;
  double total = 0.0;
  for (const double area : areas)
  {
    total += area;
  }
  coarse.Size = std::sqrt(total);
  // No cell is without any area, so that its means are finite.
  constexpr double ofTotal = 1e-12;
  const double least = ofTotal * total + std::numeric_limits<double>::min();
  coarse.Shares.assign(n, 0.0);
  side.MSP.assign(n, 0.0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const int cell = cells.CellOfVertex[v];
    if (cell >= 0)
    {
      coarse.Shares[cell] += areas[v] + least;
      side.MSP[cell] += (areas[v] + least) * fine.MSP[v];
    }
  }
  double sum = 0.0;
  for (int cell = 0; cell < n; ++cell)
  {
    side.MSP[cell] /= coarse.Shares[cell];
    sum += coarse.Shares[cell];
  }
  side.Slices = fine.Slices;
  side.Skeleton = fine.Skeleton;
  for (int node = 0; node < side.Skeleton.NumberOfNodes(); ++node)
  {
    side.Skeleton.Graph[node].Vertices.clear();
  }
  coarse.NumberOfPatches = std::min(n, NumberOfPatches);
  for (int cell = 0; cell < n; ++cell)
  {
    const int sample = cells.Samples[cell];
    coarse.Shares[cell] /= sum;
    // Of more components than there are patches, those beyond count as part of the first.
    coarse.Patches.push_back(std::max(cells.PatchOfVertex[sample], 0));
    side.Mesh.Points.push_back(mesh.Points[sample]);
    side.NodeOfVertex.push_back(fine.NodeOfVertex[sample]);
    if (side.NodeOfVertex.back() >= 0)
    {
      side.Skeleton.Graph[side.NodeOfVertex.back()].Vertices.push_back(cell);
    }
  }
  std::set<std::array<int, 3>> known;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const std::array<int, 3> corners{ cells.CellOfVertex[a], cells.CellOfVertex[b],
      cells.CellOfVertex[c] };
    std::array<int, 3> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] >= 0 && sorted[0] != sorted[1] && sorted[1] != sorted[2] &&
      known.insert(sorted).second)
    {
      side.Mesh.Triangles.push_back(corners);
    }
  }
  side.Mesh.BuildConnectivity();
  coarse.CellOfVertex = cells.CellOfVertex;
  return coarse;
}
}
