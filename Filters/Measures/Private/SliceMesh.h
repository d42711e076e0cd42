// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceMesh_h
#define marrow_SliceMesh_h

#include "TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// A copy of a mesh laid out for walks from triangle to triangle, with vertices and triangles in
/// breadth-first order and 12 bytes for a half-edge, since walks are bound by memory on large meshes.
/// Vertices go by their rank in that order.
struct SliceMesh
{
  /// How a walk goes on in the triangle entered over a half-edge.
  struct HalfEdge
  {
    int Apex; ///< rank of the triangle's third vertex
    /// Half-edge of the neighbour across (apex, start), and of that across (end, apex); -1 on a border.
    int Onward[2];
  };

  explicit SliceMesh(const TriangleMesh& mesh);

  std::vector<int> VertexOfRank; ///< points that no triangle uses are left out
  std::vector<int> RankOfVertex; ///< -1 for a point that no triangle uses
  std::vector<Eigen::Vector3d> Points;
  std::vector<HalfEdge> HalfEdges;
  std::vector<int> Start;      ///< by half-edge: rank of the vertex it leaves
  std::vector<int> Across;     ///< by half-edge: the opposite one, -1 on a border
  std::vector<int> RingOffset; ///< by rank, into Ring
  std::vector<int> Ring;       ///< the half-edges opposite to a vertex in its triangles
};
}

#endif
