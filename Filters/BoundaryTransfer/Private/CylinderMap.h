// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CylinderMap_h
#define marrow_CylinderMap_h

#include "CoveringRegion.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <unordered_map>
#include <vector>

namespace marrow
{
/// Cylindrical parameterization of an annulus (T:4.3): v is 0 on the first rim, 1 on the second,
/// u runs once round in [0,1). Both are harmonic; the rims are free in u, so that neither is twisted
/// against the other. Where u jumps, corners carry the value that is continuous in their triangle.
class CylinderMap
{
public:
  /// `axis` with the region's rims decides which way u runs: right-handed about it.
  static std::optional<CylinderMap> Build(PathFinder& paths, const TriangleMesh& mesh,
    CoveringRegion region, const Eigen::Vector3d& center, const Eigen::Vector3d& axis);

  const CoveringRegion& GetRegion() const { return this->Region; }
  bool Contains(int vertex) const { return this->LocalOfVertex.count(vertex) > 0; }
  /// (u, v) of a vertex of the region, u in [0,1).
  Eigen::Vector2d OfVertex(int vertex) const;
  /// (u, v) of the corners of a triangle, continuous in it; `index` into GetRegion().Triangles.
  const std::array<Eigen::Vector2d, 3>& Corners(std::size_t index) const { return this->Uv[index]; }
  /// The point of the surface at (u, v); of the nearest triangle if none holds it.
  Eigen::Vector3d PointAt(const Eigen::Vector2d& uv) const;
  /// Shifts u by an offset.
  void Rotate(double offset);

private:
  CylinderMap(const TriangleMesh& mesh, CoveringRegion region);
  bool Solve(PathFinder& paths);
  void MarkJumps(const std::vector<int>& cut, std::vector<std::array<char, 3>>& jumps) const;

  const TriangleMesh* Mesh;
  CoveringRegion Region;
  std::unordered_map<int, int> LocalOfVertex;
  std::vector<int> Vertices;
  std::vector<std::array<Eigen::Vector2d, 3>> Uv;
  std::vector<Eigen::Vector2d> VertexUv;
};

/// The u by which the target's map has to be rotated so that its rims lie like the source's: the
/// least sum of squared differences of the rims' places, in the two directions across the branch.
/// The paper compares the one direction of larger range on one rim; both directions on both rims
/// leave no mirror image and are less easily misled.
/// `sourceAxes` and `targetAxes` have the two directions as columns.
double FindRotation(const TriangleMesh& sourceMesh, const CylinderMap& source,
  const Eigen::Matrix<double, 3, 2>& sourceAxes, const TriangleMesh& targetMesh,
  const CylinderMap& target, const Eigen::Matrix<double, 3, 2>& targetAxes);
}

#endif
