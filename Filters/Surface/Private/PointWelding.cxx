// SPDX-License-Identifier: BSD-3-Clause
#include "PointWelding.h"

#include "EdgeGroups.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
std::uint64_t Mixed(std::uint64_t value)
{
  value ^= value >> 33;
  value *= 0xff51afd7ed558ccdULL; // the finalizer of MurmurHash3
  value ^= value >> 33;
  return value;
}

std::uint64_t Hash(const Eigen::Vector3d& point)
{
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double coordinate = point[k] + 0.0; // -0 becomes 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);
    hash = Mixed(hash * 31 + bits);
  }
  return hash;
}

/// The edges that have not just two triangles.
std::vector<std::pair<int, int>> OpenEdges(const TriangleMesh& mesh)
{
  std::vector<std::pair<int, int>> open;
  const EdgeGroups edges(mesh);
  for (int e = 0; e < edges.NumberOfEdges(); ++e)
  {
    if (edges.SizeOf(e) != 2)
    {
      open.push_back(std::minmax({ mesh.From(*edges.begin(e)), mesh.To(*edges.begin(e)) }));
    }
  }
  return open;
}

/// Merges vertices that have the same place, where that lays open edges onto each other. Keeps
/// `target`, from the vertices there were at first, leading straight to the last one.
int WeldAt(TriangleMesh& mesh, const std::vector<std::pair<int, int>>& openEdges,
  const std::vector<int>& place, std::vector<int>& target)
{
  struct Placed
  {
    std::pair<int, int> Places;
    std::pair<int, int> Edge;
    bool operator<(const Placed& other) const
    {
      return Places != other.Places ? Places < other.Places : Edge < other.Edge;
    }
  };
  std::vector<Placed> placed;
  placed.reserve(openEdges.size());
  for (const auto& edge : openEdges)
  {
    placed.push_back({ std::minmax({ place[edge.first], place[edge.second] }), edge });
  }
  std::sort(placed.begin(), placed.end());
  std::vector<char> closes(mesh.Points.size(), 0);
  for (std::size_t i = 1; i < placed.size(); ++i)
  {
    if (placed[i].Places == placed[i - 1].Places)
    {
      for (const auto& edge : { placed[i - 1].Edge, placed[i].Edge })
      {
        closes[edge.first] = closes[edge.second] = 1;
      }
    }
  }
  std::vector<int> newTarget(mesh.Points.size());
  std::vector<int> firstAt(mesh.Points.size(), -1); // per place
  int merged = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    newTarget[v] = v;
    if (closes[v])
    {
      int& first = firstAt[place[v]];
      first = first < 0 ? v : first;
      newTarget[v] = first;
      merged += first != v ? 1 : 0;
    }
  }
  if (merged > 0)
  {
    for (auto& triangle : mesh.Triangles)
    {
      for (int& corner : triangle)
      {
        corner = newTarget[corner];
      }
    }
    for (int& v : target)
    {
      v = newTarget[v];
    }
  }
  return merged;
}

/// The distance between neighbouring numbers of the coordinates' precision at the largest of them.
double RoundingUnit(const TriangleMesh& mesh)
{
  bool single = true;
  double largest = 0.0;
  for (const auto& triangle : mesh.Triangles)
  {
    for (int corner : triangle)
    {
      const Eigen::Vector3d& point = mesh.Points[corner];
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
      for (int k = 0; single && k < 3; ++k)
      {
        single = static_cast<double>(static_cast<float>(point[k])) == point[k];
      }
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0,
    exponent - (single ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits));
}

/// For every end of an open edge one that differs from it by rounding at most, and is not its
/// neighbour; itself for all other vertices. By place, so that the file's order plays no part.
std::vector<int> NearPlaces(
  const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& openEdges)
{
  std::vector<int> candidates;
  for (const auto& edge : openEdges)
  {
    candidates.push_back(edge.first);
    candidates.push_back(edge.second);
  }
  std::sort(candidates.begin(), candidates.end(),
    [&](int a, int b)
    {
      const auto& p = mesh.Points[a];
      const auto& q = mesh.Points[b];
      return p != q ? std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3)
                    : a < b;
    });
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());

  std::vector<int> place(mesh.Points.size());
  std::iota(place.begin(), place.end(), 0);
  constexpr double room = 1.0625; // for the rounding of the difference itself
  const double unit = room * RoundingUnit(mesh);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const int a = candidates[i];
    for (std::size_t j = i + 1; j < candidates.size() && place[a] == a; ++j)
    {
      const int b = candidates[j];
      if (mesh.Points[b][0] - mesh.Points[a][0] > unit)
      {
        break;
      }
      if (place[b] == b && (mesh.Points[b] - mesh.Points[a]).cwiseAbs().maxCoeff() <= unit &&
        !std::binary_search(
          openEdges.begin(), openEdges.end(), std::pair<int, int>(std::min(a, b), std::max(a, b))))
      {
        place[b] = a;
      }
    }
  }
  return place;
}
}

std::vector<int> FirstEqualPoint(const std::vector<Eigen::Vector3d>& points)
{
  std::size_t slots = 16;
  while (slots < 2 * points.size())
  {
    slots *= 2;
  }
  std::vector<int> table(slots, -1);
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::size_t slot = Hash(points[i]) & (slots - 1);
    while (table[slot] >= 0 && points[table[slot]] != points[i])
    {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] < 0)
    {
      table[slot] = static_cast<int>(i);
    }
    first[i] = table[slot];
  }
  return first;
}

int WeldPoints(MendedMesh& mesh, std::vector<int>& representative)
{
  representative.resize(mesh.Mesh.Points.size());
  std::iota(representative.begin(), representative.end(), 0);
  std::vector<std::pair<int, int>> openEdges = OpenEdges(mesh.Mesh);
  if (openEdges.empty())
  {
    return 0;
  }
  const int equal = WeldAt(mesh.Mesh, openEdges, FirstEqualPoint(mesh.Mesh.Points), representative);
  if (equal > 0)
  {
    openEdges = OpenEdges(mesh.Mesh);
  }
  return equal + WeldAt(mesh.Mesh, openEdges, NearPlaces(mesh.Mesh, openEdges), representative);
}
}
