// SPDX-License-Identifier: BSD-3-Clause
#include "SheetPairing.h"

#include "Constants.h"
#include "EdgeGroups.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// A triangle at an edge, seen along it.
struct Leaf
{
  double Angle; ///< of the triangle about the edge, from the first one's, counter-clockwise
  bool Forward; ///< whether its half-edge runs from the lower vertex to the higher
  int HalfEdge;
};

std::vector<Leaf> LeavesRound(const TriangleMesh& mesh, const int* begin, const int* end)
{
  const int low = std::min(mesh.From(*begin), mesh.To(*begin));
  const int high = std::max(mesh.From(*begin), mesh.To(*begin));
  const Eigen::Vector3d axis = (mesh.Points[high] - mesh.Points[low]).normalized();
  auto direction = [&](int h) -> Eigen::Vector3d
  {
    const Eigen::Vector3d toApex = mesh.Points[mesh.To(TriangleMesh::Next(h))] - mesh.Points[low];
    return toApex - toApex.dot(axis) * axis;
  };
  const Eigen::Vector3d x = direction(*begin).normalized();
  const Eigen::Vector3d y = axis.cross(x);
  std::vector<Leaf> leaves;
  for (const int* h = begin; h != end; ++h)
  {
    const Eigen::Vector3d d = direction(*h);
    double angle = h == begin ? 0.0 : std::atan2(d.dot(y), d.dot(x));
    angle = angle < 0.0 ? angle + 2.0 * Pi : angle;
    leaves.push_back({ angle, mesh.From(*h) == low, *h });
  }
  std::sort(leaves.begin(), leaves.end(),
    [](const Leaf& a, const Leaf& b)
    { return a.Angle != b.Angle ? a.Angle < b.Angle : a.HalfEdge < b.HalfEdge; });
  return leaves;
}

void Pair(TriangleMesh& mesh, int h, int g)
{
  mesh.Opposite[h] = g;
  mesh.Opposite[g] = h;
}

/// Solid lies behind a triangle: a backward one opens a wedge of it, seen counter-clockwise, the
/// next forward one that is not spoken for closes it.
void PairWedges(TriangleMesh& mesh, const std::vector<Leaf>& leaves)
{
  std::vector<int> open;
  const std::size_t size = leaves.size();
  for (std::size_t i = 0; i < 2 * size; ++i) // twice round, for wedges across the start
  {
    const Leaf& leaf = leaves[i % size];
    if (mesh.Opposite[leaf.HalfEdge] >= 0)
    {
      continue;
    }
    if (!leaf.Forward)
    {
      if (i < size)
      {
        open.push_back(leaf.HalfEdge);
      }
    }
    else if (!open.empty())
    {
      Pair(mesh, open.back(), leaf.HalfEdge);
      open.pop_back();
    }
  }
}

void PairFlattest(TriangleMesh& mesh, const std::vector<Leaf>& leaves)
{
  struct Candidate
  {
    double Bend;
    int First;
    int Second;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    for (std::size_t j = i + 1; j < leaves.size(); ++j)
    {
      candidates.push_back({ std::abs(leaves[j].Angle - leaves[i].Angle - Pi), leaves[i].HalfEdge,
        leaves[j].HalfEdge });
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Bend < b.Bend; });
  for (const Candidate& candidate : candidates)
  {
    if (mesh.Opposite[candidate.First] < 0 && mesh.Opposite[candidate.Second] < 0)
    {
      Pair(mesh, candidate.First, candidate.Second);
    }
  }
}
}

int PairSheets(TriangleMesh& mesh)
{
  mesh.Opposite.assign(3 * mesh.Triangles.size(), -1);
  const EdgeGroups edges(mesh);
  int crowded = 0;
  for (int e = 0; e < edges.NumberOfEdges(); ++e)
  {
    const int* first = edges.begin(e);
    if (edges.SizeOf(e) == 2)
    {
      Pair(mesh, first[0], first[1]);
    }
    else if (edges.SizeOf(e) > 2)
    {
      ++crowded;
      const std::vector<Leaf> leaves = LeavesRound(mesh, first, edges.end(e));
      const auto forward =
        std::count_if(leaves.begin(), leaves.end(), [](const Leaf& leaf) { return leaf.Forward; });
      if (2 * forward == edges.SizeOf(e))
      {
        PairWedges(mesh, leaves);
      }
      else
      {
        PairFlattest(mesh, leaves);
      }
    }
  }
  return crowded;
}
}
