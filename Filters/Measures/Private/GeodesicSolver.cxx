// SPDX-License-Identifier: BSD-3-Clause
#include "GeodesicSolver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace marrow
{
namespace
{
// Gains below this are not passed on; far below the error of the method.
constexpr float RelativeGain = 1e-4f;
// Every sweep settles at least the next vertex of each path; in practice 40 are enough for 20,000
// faces, 200 for a million.
constexpr int MaximumNumberOfSweeps = 1000;

/// Visits until nothing changes any more: 18 to a vertex on creatures of 20,000 faces, and more on finer
/// ones, as counted up to 1,000,000 faces. Only progress rests on it.
double ExpectedVisits(int numberOfVertices)
{
  return numberOfVertices * 18.0 * std::pow(numberOfVertices / 1.0e4, 0.37);
}
}

GeodesicSolver::GeodesicSolver(const TriangleMesh& mesh)
{
  std::vector<int> rankOfVertex(mesh.Points.size(), -1);
  this->VertexOfRank.reserve(mesh.Points.size());
  std::vector<double> distance(mesh.Points.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (int seed = 0; seed < mesh.NumberOfVertices(); ++seed)
  {
    if (mesh.Outgoing[seed] < 0 || rankOfVertex[seed] >= 0)
    {
      continue;
    }
    this->BeginOfComponent.push_back(static_cast<int>(this->VertexOfRank.size()));
    distance[seed] = 0.0;
    queue.push({ 0.0, seed });
    while (!queue.empty())
    {
      const auto [reached, vertex] = queue.top();
      queue.pop();
      if (rankOfVertex[vertex] >= 0)
      {
        continue;
      }
      rankOfVertex[vertex] = static_cast<int>(this->VertexOfRank.size());
      this->VertexOfRank.push_back(vertex);
      mesh.ForEachNeighbor(vertex,
        [&, from = vertex, base = reached](int next)
        {
          const double sum = base + (mesh.Points[next] - mesh.Points[from]).norm();
          if (sum < distance[next])
          {
            distance[next] = sum;
            queue.push({ sum, next });
          }
        });
    }
  }
  this->BeginOfComponent.push_back(static_cast<int>(this->VertexOfRank.size()));

  this->CornerOffset.reserve(this->VertexOfRank.size() + 1);
  this->Corners.reserve(3 * mesh.Triangles.size());
  this->CornerOffset.push_back(0);
  std::vector<int> cornerOfHalfEdge(mesh.Opposite.size(), -1);
  for (int vertex : this->VertexOfRank)
  {
    mesh.ForEachOutgoing(vertex,
      [&](int h)
      {
        cornerOfHalfEdge[h] = static_cast<int>(this->Corners.size());
        const int first = mesh.To(h);
        const int second = mesh.From(TriangleMesh::Previous(h));
        const Eigen::Vector3d base = mesh.Points[second] - mesh.Points[first];
        const Eigen::Vector3d toVertex = mesh.Points[vertex] - mesh.Points[first];
        const double length = base.norm();
        const double x = length > 0.0 ? base.dot(toVertex) / length : 0.0;
        const double y = std::sqrt(std::max(0.0, toVertex.squaredNorm() - x * x));
        Corner corner;
        corner.First = rankOfVertex[first];
        corner.Second = rankOfVertex[second];
        // Half-edges for now, corners once all have their number.
        corner.CornerAtFirst = TriangleMesh::Next(h);
        corner.CornerAtSecond = TriangleMesh::Previous(h);
        corner.X = static_cast<float>(x);
        corner.Y = static_cast<float>(y);
        corner.Base = static_cast<float>(length);
        corner.InverseBase = corner.Base > 0.0f ? 1.0f / corner.Base : 0.0f;
        corner.ToFirst = static_cast<float>(toVertex.norm());
        corner.ToSecond = static_cast<float>((mesh.Points[vertex] - mesh.Points[second]).norm());
        this->Corners.push_back(corner);
      });
    this->CornerOffset.push_back(static_cast<int>(this->Corners.size()));
  }
  for (Corner& corner : this->Corners)
  {
    corner.CornerAtFirst = cornerOfHalfEdge[corner.CornerAtFirst];
    corner.CornerAtSecond = cornerOfHalfEdge[corner.CornerAtSecond];
  }
}

// The widest registers of the machine that runs it, by a choice at load time. Every clone does the
// same operations in the same precision, so the bits are the same.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
bool GeodesicSolver::Update(const Corner* corners, const char* pending, int numberOfCorners,
  const float* distances, int firstRank, float* own)
{
  float reached[Lanes];
  std::copy(own, own + Lanes, reached);
  int changed = 0;
  for (int c = 0; c < numberOfCorners; ++c)
  {
    if (!pending[c])
    {
      continue;
    }
    const Corner& corner = corners[c];
    const float* first = distances + static_cast<std::size_t>(Lanes) * (corner.First - firstRank);
    const float* second = distances + static_cast<std::size_t>(Lanes) * (corner.Second - firstRank);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const float a = first[lane];
      const float b = second[lane];
      // The unfolded source is (x, -y). Infinite distances make NaN here, and then every comparison
      // fails, which leaves the way along an edge.
      const float x = 0.5f * (corner.Base + (a - b) * (a + b) * corner.InverseBase);
      const float ySquared = a * a - x * x;
      const float y = std::sqrt(ySquared > 0.0f ? ySquared : 0.0f);
      const float dx = corner.X - x;
      const float dy = corner.Y + y;
      const float straight = std::sqrt(dx * dx + dy * dy);
      const float crossing = x * corner.Y + corner.X * y;
      const bool passes = (ySquared >= 0.0f) & (crossing >= 0.0f) & (crossing <= corner.Base * dy);
      const float overFirst = a + corner.ToFirst;
      const float overSecond = b + corner.ToSecond;
      const float alongEdge = overFirst < overSecond ? overFirst : overSecond;
      const float offer = passes ? straight : alongEdge;
      const float old = reached[lane];
      const bool gains = offer < old * (1.0f - RelativeGain);
      reached[lane] = gains ? offer : old;
      changed |= gains ? 1 : 0;
    }
  }
  std::copy(reached, reached + Lanes, own);
  return changed != 0;
}

bool GeodesicSolver::Distances(int component, const std::vector<int>& sources,
  std::vector<float>& distances, const Progress& progress) const
{
  const int begin = this->BeginOfComponent[component];
  const int end = this->BeginOfComponent[component + 1];
  distances.assign(
    static_cast<std::size_t>(Lanes) * (end - begin), std::numeric_limits<float>::infinity());
  const int firstCorner = this->CornerOffset[begin];
  std::vector<char> pendingCorner(this->CornerOffset[end] - firstCorner, 0);
  std::vector<char> pending(end - begin, 0);
  int numberPending = 0;
  const auto wake = [&](int rank, int corner)
  {
    pendingCorner[corner - firstCorner] = 1;
    numberPending += pending[rank - begin] ? 0 : 1;
    pending[rank - begin] = 1;
  };
  const auto wakeNeighbors = [&](int rank)
  {
    for (int i = this->CornerOffset[rank]; i < this->CornerOffset[rank + 1]; ++i)
    {
      const Corner& corner = this->Corners[i];
      wake(corner.First, corner.CornerAtFirst);
      wake(corner.Second, corner.CornerAtSecond);
    }
  };
  const auto distancesOf = [&](int rank)
  { return distances.data() + static_cast<std::size_t>(Lanes) * (rank - begin); };

  for (std::size_t lane = 0; lane < sources.size(); ++lane)
  {
    distancesOf(sources[lane])[lane] = 0.0f;
    wakeNeighbors(sources[lane]);
  }
  const double expectedVisits = ExpectedVisits(end - begin);
  double visits = 0.0;
  for (int sweep = 0; sweep < MaximumNumberOfSweeps && numberPending > 0; ++sweep)
  {
    if (!Report(progress, std::min(1.0, visits / expectedVisits)))
    {
      return false;
    }
    const bool forward = sweep % 2 == 0;
    for (int i = 0; i < end - begin; ++i)
    {
      const int rank = forward ? begin + i : end - 1 - i;
      if (!pending[rank - begin])
      {
        continue;
      }
      pending[rank - begin] = 0;
      --numberPending;
      visits += 1.0;
      const int offset = this->CornerOffset[rank];
      const int numberOfCorners = this->CornerOffset[rank + 1] - offset;
      char* pendingHere = pendingCorner.data() + (offset - firstCorner);
      const bool changed = Update(this->Corners.data() + offset, pendingHere, numberOfCorners,
        distances.data(), begin, distancesOf(rank));
      std::fill(pendingHere, pendingHere + numberOfCorners, 0);
      if (changed)
      {
        wakeNeighbors(rank);
      }
    }
  }
  return true;
}
}
