// SPDX-License-Identifier: BSD-3-Clause
#include "FlatTriangles.h"

#include "EdgeOperations.h"
#include "MeshCheck.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace marrow
{
namespace
{
/// What the rounding of the coordinates and of a few operations on them amounts to.
double Rounding(const TriangleMesh& mesh)
{
  double largest = 0.0;
  for (const auto& triangle : mesh.Triangles)
  {
    for (int corner : triangle)
    {
      largest = std::max(largest, mesh.Points[corner].cwiseAbs().maxCoeff());
    }
  }
  return 4.0 * std::numeric_limits<double>::epsilon() * largest;
}

double Height(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double longest =
    std::sqrt(std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() }));
  return longest > 0.0 ? (b - a).cross(c - a).norm() / longest : 0.0;
}

class Flattening
{
public:
  Flattening(const TriangleMesh& mesh, double rounding)
    : Edges(mesh)
    , Least(rounding)
  {
  }

  EdgeOperations Edges;
  int Flipped = 0;

  bool IsFlat(int t) const
  {
    const TriangleMesh& mesh = this->Edges.Mesh();
    const auto& c = mesh.Triangles[t];
    return Height(mesh.Points[c[0]], mesh.Points[c[1]], mesh.Points[c[2]]) <= this->Least;
  }

  /// Whether there was a way out.
  bool Mend(int t)
  {
    const TriangleMesh& mesh = this->Edges.Mesh();
    auto length = [&](int h)
    { return (mesh.Points[mesh.To(h)] - mesh.Points[mesh.From(h)]).norm(); };
    int shortest = 3 * t;
    int longest = shortest;
    for (int h = 3 * t + 1; h < 3 * t + 3; ++h)
    {
      shortest = length(h) < length(shortest) ? h : shortest;
      longest = length(h) > length(longest) ? h : longest;
    }
    if (length(shortest) <= this->Least)
    {
      for (const bool backward : { false, true })
      {
        if (this->Edges.CanCollapse(shortest, backward))
        {
          this->Edges.Collapse(shortest, backward);
          return true;
        }
      }
      return false;
    }
    if (!this->Edges.CanFlip(longest))
    {
      return false;
    }
    // Only if both triangles come out with an area: else two flat ones may take turns for ever.
    const int opposite = mesh.Opposite[longest];
    const Eigen::Vector3d& apex = mesh.Points[mesh.To(TriangleMesh::Next(longest))];
    const Eigen::Vector3d& otherApex = mesh.Points[mesh.To(TriangleMesh::Next(opposite))];
    for (int end : { mesh.From(longest), mesh.To(longest) })
    {
      if (Height(mesh.Points[end], apex, otherApex) <= this->Least)
      {
        return false;
      }
    }
    this->Edges.Flip(longest);
    ++this->Flipped;
    return true;
  }

private:
  double Least;
};
}

namespace
{
/// Connected parts all of whose triangles are flat have no neighbour that could take their place.
void RemoveFlatParts(MendedMesh& mesh, double rounding)
{
  int numberOfParts = 0;
  const std::vector<int> parts = TriangleComponents(mesh.Mesh, numberOfParts);
  std::vector<char> hasArea(numberOfParts, 0);
  for (int t = 0; t < mesh.Mesh.NumberOfTriangles(); ++t)
  {
    const auto& c = mesh.Mesh.Triangles[t];
    if (Height(mesh.Mesh.Points[c[0]], mesh.Mesh.Points[c[1]], mesh.Mesh.Points[c[2]]) > rounding)
    {
      hasArea[parts[t]] = 1;
    }
  }
  std::vector<char> keep(parts.size());
  std::transform(parts.begin(), parts.end(), keep.begin(), [&](int part) { return hasArea[part]; });
  if (std::find(keep.begin(), keep.end(), 0) != keep.end())
  {
    mesh.KeepTriangles(keep);
    mesh.Mesh.BuildConnectivity();
  }
}
}

int RemoveFlatTriangles(MendedMesh& mesh)
{
  const double rounding = Rounding(mesh.Mesh);
  std::vector<int> flat;
  for (int t = 0; t < mesh.Mesh.NumberOfTriangles(); ++t)
  {
    const auto& c = mesh.Mesh.Triangles[t];
    if (Height(mesh.Mesh.Points[c[0]], mesh.Mesh.Points[c[1]], mesh.Mesh.Points[c[2]]) <= rounding)
    {
      flat.push_back(t);
    }
  }
  if (flat.empty())
  {
    return 0;
  }
  Flattening flattening(mesh.Mesh, rounding);
  // What one has no way out of may be open once its neighbour is mended.
  for (bool changed = true; changed;)
  {
    changed = false;
    for (int t : flat)
    {
      if (!flattening.Edges.IsRemoved(t) && flattening.IsFlat(t))
      {
        changed = flattening.Mend(t) || changed;
      }
    }
  }
  const TriangleMesh& mended = flattening.Edges.Mesh();
  std::vector<char> keep(mended.Triangles.size());
  for (int t = 0; t < mended.NumberOfTriangles(); ++t)
  {
    keep[t] = flattening.Edges.IsRemoved(t) ? 0 : 1;
  }
  mesh.Mesh.Triangles = mended.Triangles;
  mesh.KeepTriangles(keep);
  mesh.Mesh.BuildConnectivity();
  RemoveFlatParts(mesh, rounding);
  return flattening.Flipped;
}
}
