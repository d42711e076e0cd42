// SPDX-License-Identifier: BSD-3-Clause
#include "FaceRemoval.h"

#include "EdgeGroups.h"
#include "PointWelding.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace marrow
{
namespace
{
int Drop(MendedMesh& mesh, const std::vector<char>& keep)
{
  const int dropped = static_cast<int>(std::count(keep.begin(), keep.end(), 0));
  if (dropped > 0)
  {
    mesh.KeepTriangles(keep);
  }
  return dropped;
}

/// Triangles on the same three vertices: they share each edge, so one edge of each is enough.
int RemoveOnSameVertices(MendedMesh& mesh, std::vector<int>& twinOfCell)
{
  const TriangleMesh& triangles = mesh.Mesh;
  std::vector<char> keep(triangles.Triangles.size(), 1);
  const EdgeGroups edges(triangles);
  for (int e = 0; e < edges.NumberOfEdges(); ++e)
  {
    for (const int* h = edges.begin(e); edges.SizeOf(e) > 1 && h != edges.end(e); ++h)
    {
      const int third = triangles.To(TriangleMesh::Next(*h));
      for (const int* g = edges.begin(e); g != h; ++g)
      {
        if (keep[*g / 3] && keep[*h / 3] && triangles.To(TriangleMesh::Next(*g)) == third)
        {
          keep[*h / 3] = 0;
          twinOfCell[mesh.CellOfTriangle[*h / 3]] = mesh.CellOfTriangle[*g / 3];
        }
      }
    }
  }
  return Drop(mesh, keep);
}

std::vector<int> PartsOverEdges(const TriangleMesh& mesh, int& numberOfParts)
{
  std::vector<int> root(mesh.Triangles.size());
  std::iota(root.begin(), root.end(), 0);
  auto find = [&](int t)
  {
    while (root[t] != t)
    {
      t = root[t] = root[root[t]];
    }
    return t;
  };
  const EdgeGroups edges(mesh);
  for (int e = 0; e < edges.NumberOfEdges(); ++e)
  {
    for (const int* h = edges.begin(e) + 1; h != edges.end(e); ++h)
    {
      const auto [low, high] = std::minmax({ find(*h / 3), find(*edges.begin(e) / 3) });
      root[high] = low;
    }
  }
  std::vector<int> part(mesh.Triangles.size());
  numberOfParts = 0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    part[t] = find(t) == t ? numberOfParts++ : part[root[t]];
  }
  return part;
}

/// Parts on vertices of their own, but at the places of another part's triangles.
int RemoveCoveredParts(MendedMesh& mesh, std::vector<int>& twinOfCell)
{
  const TriangleMesh& triangles = mesh.Mesh;
  const std::vector<int> place = FirstEqualPoint(triangles.Points);
  std::vector<char> shared(place.size(), 0);
  for (std::size_t v = 0; v < place.size(); ++v)
  {
    if (place[v] != static_cast<int>(v))
    {
      shared[v] = shared[place[v]] = 1;
    }
  }
  struct Placed
  {
    std::array<int, 3> Places;
    int Triangle;
    bool operator<(const Placed& other) const
    {
      return Places != other.Places ? Places < other.Places : Triangle < other.Triangle;
    }
  };
  std::vector<Placed> placed;
  for (int t = 0; t < triangles.NumberOfTriangles(); ++t)
  {
    const auto& c = triangles.Triangles[t];
    if (shared[c[0]] && shared[c[1]] && shared[c[2]])
    {
      placed.push_back({ { place[c[0]], place[c[1]], place[c[2]] }, t });
      std::sort(placed.back().Places.begin(), placed.back().Places.end());
    }
  }
  if (placed.size() < 2)
  {
    return 0;
  }
  std::sort(placed.begin(), placed.end());
  int numberOfParts = 0;
  const std::vector<int> part = PartsOverEdges(triangles, numberOfParts);
  std::vector<int> size(numberOfParts, 0);
  for (int p : part)
  {
    ++size[p];
  }
  std::vector<int> covered(numberOfParts, 0);
  std::vector<int> twin(triangles.Triangles.size(), -1);
  for (std::size_t i = 1; i < placed.size(); ++i)
  {
    // The first of equal ones in a part before this one's.
    for (std::size_t j = i; j-- > 0 && placed[j].Places == placed[i].Places;)
    {
      if (part[placed[j].Triangle] < part[placed[i].Triangle])
      {
        twin[placed[i].Triangle] = placed[j].Triangle;
      }
    }
    covered[part[placed[i].Triangle]] += twin[placed[i].Triangle] >= 0 ? 1 : 0;
  }
  std::vector<char> keep(triangles.Triangles.size(), 1);
  for (int t = 0; t < triangles.NumberOfTriangles(); ++t)
  {
    if (covered[part[t]] == size[part[t]])
    {
      keep[t] = 0;
      twinOfCell[mesh.CellOfTriangle[t]] = mesh.CellOfTriangle[twin[t]];
    }
  }
  return Drop(mesh, keep);
}
}

int RemoveCollapsedTriangles(MendedMesh& mesh)
{
  std::vector<char> keep(mesh.Mesh.Triangles.size());
  std::transform(mesh.Mesh.Triangles.begin(), mesh.Mesh.Triangles.end(), keep.begin(),
    [](const std::array<int, 3>& c) { return c[0] != c[1] && c[1] != c[2] && c[2] != c[0]; });
  return Drop(mesh, keep);
}

int RemoveTwinTriangles(MendedMesh& mesh, std::vector<int>& twinOfCell)
{
  const int onSameVertices = RemoveOnSameVertices(mesh, twinOfCell);
  return onSameVertices + RemoveCoveredParts(mesh, twinOfCell);
}
}
