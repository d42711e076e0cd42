// SPDX-License-Identifier: BSD-3-Clause
#include "FaceOrientation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
/// A forest over triangles that knows for each whether it is turned against its root.
class TurningForest
{
public:
  explicit TurningForest(int size)
    : Parent(size)
    , Turned(size, 0)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  /// The root, and whether the triangle is turned against it.
  std::pair<int, bool> Find(int triangle)
  {
    int root = triangle;
    bool turned = false;
    while (this->Parent[root] != root)
    {
      turned ^= this->Turned[root] != 0;
      root = this->Parent[root];
    }
    bool rest = turned;
    while (this->Parent[triangle] != triangle)
    {
      const int next = this->Parent[triangle];
      const bool own = this->Turned[triangle] != 0;
      this->Parent[triangle] = root;
      this->Turned[triangle] = rest;
      rest ^= own;
      triangle = next;
    }
    return { root, turned };
  }

  /// False if the two are joined already, and the other way round.
  bool Join(int a, int b, bool turned)
  {
    const auto [rootA, turnedA] = this->Find(a);
    const auto [rootB, turnedB] = this->Find(b);
    const bool between = turnedA ^ turnedB ^ turned;
    if (rootA == rootB)
    {
      return !between;
    }
    this->Parent[std::max(rootA, rootB)] = std::min(rootA, rootB);
    this->Turned[std::max(rootA, rootB)] = between;
    return true;
  }

private:
  std::vector<int> Parent;
  std::vector<char> Turned;
};

bool RunAlike(const TriangleMesh& mesh, int h)
{
  return mesh.From(h) == mesh.From(mesh.Opposite[h]);
}

void Unpair(TriangleMesh& mesh, int h)
{
  mesh.Opposite[mesh.Opposite[h]] = -1;
  mesh.Opposite[h] = -1;
}

/// How the two triangles at an edge lie: 1 in a plane, -1 folded onto each other.
double Flatness(const TriangleMesh& mesh, int h)
{
  const Eigen::Vector3d a = mesh.AreaVector(h / 3).normalized();
  const Eigen::Vector3d b = mesh.AreaVector(mesh.Opposite[h] / 3).normalized();
  return RunAlike(mesh, h) ? -a.dot(b) : a.dot(b);
}

/// Joins all triangles over their edges; where that fails, anew with the flattest edges first, so that
/// what has to be cut is sharp. Returns how many edges were cut.
int JoinTriangles(TriangleMesh& mesh, TurningForest& forest)
{
  bool fails = false;
  const int numberOfHalfEdges = 3 * mesh.NumberOfTriangles();
  for (int h = 0; h < numberOfHalfEdges && !fails; ++h)
  {
    const int g = mesh.Opposite[h];
    fails = g > h && !forest.Join(h / 3, g / 3, RunAlike(mesh, h));
  }
  if (!fails)
  {
    return 0;
  }
  std::vector<std::pair<double, int>> edges;
  for (int h = 0; h < numberOfHalfEdges; ++h)
  {
    if (mesh.Opposite[h] > h)
    {
      edges.push_back({ -Flatness(mesh, h), h });
    }
  }
  std::sort(edges.begin(), edges.end());
  forest = TurningForest(mesh.NumberOfTriangles());
  int cut = 0;
  for (const auto& [sharpness, h] : edges)
  {
    if (!forest.Join(h / 3, mesh.Opposite[h] / 3, RunAlike(mesh, h)))
    {
      Unpair(mesh, h);
      ++cut;
    }
  }
  return cut;
}

void Turn(TriangleMesh& mesh, const std::vector<char>& turned)
{
  // (a, b, c) becomes (a, c, b): half-edges 0 and 2 change places, 1 stays.
  auto moved = [&](int h) { return turned[h / 3] ? 3 * (h / 3) + 2 - h % 3 : h; };
  std::vector<int> opposite(mesh.Opposite.size(), -1);
  for (std::size_t h = 0; h < opposite.size(); ++h)
  {
    const int partner = mesh.Opposite[h];
    opposite[moved(static_cast<int>(h))] = partner < 0 ? -1 : moved(partner);
  }
  mesh.Opposite = std::move(opposite);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (turned[t])
    {
      std::swap(mesh.Triangles[t][1], mesh.Triangles[t][2]);
    }
  }
}

/// A lid over the border as large as this share of the part: half way between a hemisphere, 1/2, which
/// has an inside, and a plane, 1, which has none.
constexpr double LargestLid = 0.75;

/// What tells the outside of one part.
struct Side
{
  Eigen::Vector3d Middle = Eigen::Vector3d::Zero();
  Eigen::Vector3d BorderMiddle = Eigen::Vector3d::Zero();
  double Area = 0.0;
  double TurnedArea = 0.0;
  double BorderLength = 0.0;
  double LidArea = 0.0; ///< of the cones from the middle of the border to the border
  double Volume = 0.0;

  Eigen::Vector3d Apex() const
  {
    return this->BorderLength > 0.0 ? this->BorderMiddle / this->BorderLength
                                    : this->Middle / this->Area;
  }

  bool IsInsideOut(double largestCoordinate) const
  {
    // The rounding of its points can make that much volume of a sheet.
    const double noise =
      16.0 * std::numeric_limits<double>::epsilon() * largestCoordinate * this->Area;
    if (this->LidArea < LargestLid * this->Area && std::abs(this->Volume) > noise)
    {
      return this->Volume < 0.0;
    }
    return this->TurnedArea > 0.5 * this->Area;
  }
};
}

OrientationChanges OrientTriangles(TriangleMesh& mesh)
{
  OrientationChanges changes;
  const int numberOfTriangles = mesh.NumberOfTriangles();
  TurningForest forest(numberOfTriangles);
  changes.CutEdges = JoinTriangles(mesh, forest);

  std::vector<int> root(numberOfTriangles);
  std::vector<char> turned(numberOfTriangles);
  std::vector<Side> sides(numberOfTriangles); // per root
  double largestCoordinate = 0.0;
  for (int t = 0; t < numberOfTriangles; ++t)
  {
    const auto found = forest.Find(t);
    root[t] = found.first;
    turned[t] = found.second;
    Side& side = sides[root[t]];
    const double area = mesh.Area(t);
    side.Area += area;
    side.TurnedArea += turned[t] ? area : 0.0;
    side.Middle += area * mesh.Centroid(t);
    for (int h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Eigen::Vector3d& from = mesh.Points[mesh.From(h)];
      const Eigen::Vector3d& to = mesh.Points[mesh.To(h)];
      largestCoordinate = std::max(largestCoordinate, from.cwiseAbs().maxCoeff());
      if (mesh.Opposite[h] < 0)
      {
        const double length = (to - from).norm();
        side.BorderLength += length;
        side.BorderMiddle += 0.5 * length * (from + to);
      }
    }
  }
  for (int t = 0; t < numberOfTriangles; ++t)
  {
    Side& side = sides[root[t]];
    if (side.Area <= 0.0)
    {
      continue;
    }
    // Cones from the middle of the border close the part and have no volume of their own.
    const Eigen::Vector3d apex = side.Apex();
    const auto& c = mesh.Triangles[t];
    const double volume = (mesh.Points[c[0]] - apex).dot(mesh.AreaVector(t)) / 6.0;
    for (int h = 3 * t; h < 3 * t + 3; ++h)
    {
      if (mesh.Opposite[h] < 0)
      {
        const Eigen::Vector3d toBorder = mesh.Points[mesh.From(h)] - apex;
        side.LidArea += 0.5 * toBorder.cross(mesh.Points[mesh.To(h)] - apex).norm();
      }
    }
    side.Volume += turned[t] ? -volume : volume;
  }
  for (int t = 0; t < numberOfTriangles; ++t)
  {
    turned[t] ^= sides[root[t]].IsInsideOut(largestCoordinate) ? 1 : 0;
  }
  if (std::find(turned.begin(), turned.end(), 1) != turned.end())
  {
    Turn(mesh, turned);
  }
  changes.IsTurned = std::move(turned);
  return changes;
}
}
