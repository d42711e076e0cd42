// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceWalker_h
#define marrow_SliceWalker_h

#include "TriangleMesh.h"

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace marrow
{
/// The curve in which a plane through a vertex cuts the mesh, as far as it hangs together with that
/// vertex.
struct Slice
{
  enum class State
  {
    None,   ///< the plane does not separate the neighbours of the vertex: there is no curve
    Closed, ///< the curve returns to the vertex
    Open,   ///< the curve meets a border on both sides and is closed by the chord between its ends
    Abandoned ///< the perimeter exceeds the bound
  };

  State Type = State::None;
  double Perimeter = 0.0;
  Eigen::Vector3d Center = Eigen::Vector3d::Zero(); ///< length-weighted centroid of the curve
};

/// Perimeters above which a slice is of no use any more. A negative bound refuses the kind at all.
struct SliceBounds
{
  double Closed = std::numeric_limits<double>::infinity();
  double Open = std::numeric_limits<double>::infinity();
};

/// Walks slices from triangle to triangle.
///
/// Which side of the plane a vertex p lies on is decided by the sign of n · (p - q) alone, zero
/// counting as positive, and by the very same expression at the start and along the way: the edges
/// with ends on either side then form closed cycles of triangles whatever the rounding, so that a
/// walk on a closed mesh always comes home.
///
/// The walk works on its own copy of the mesh, with vertices and triangles in breadth-first order
/// and 12 bytes for a half-edge, since it is bound by memory on large meshes.
class SliceWalker
{
public:
  explicit SliceWalker(const TriangleMesh& mesh);

  /// The vertices of the mesh in breadth-first order: neighbours come close to one another. Points
  /// that no triangle uses are left out.
  const std::vector<int>& Order() const { return this->VertexOfRank; }
  /// Its place in that order, -1 for a point that no triangle uses.
  int RankOf(int vertex) const { return this->RankOfVertex[vertex]; }

  /// The slice of the plane through `vertex` with unit normal `planeNormal`. Where the plane leaves
  /// the vertex in more than two directions (a figure of eight), the least loop counts.
  /// The walk is given up as soon as the length so far plus the straight way back exceeds the
  /// bound, which by the triangle inequality the slice then does as well: the pruning is exact.
  Slice Walk(int vertex, const Eigen::Vector3d& planeNormal,
    const SliceBounds& bounds = SliceBounds()) const;

private:
  /// How the walk goes on in the triangle entered over a half-edge.
  struct HalfEdge
  {
    int Apex;     ///< rank of the triangle's third vertex
    int Next;     ///< half-edge of the neighbour across (end, apex), -1 on a border
    int Previous; ///< half-edge of the neighbour across (apex, start), -1 on a border
  };

  struct Plane;
  struct Bound;
  struct Path;

  /// Follows the curve out of the ring of the plane's vertex over half-edge `h` of that ring. True
  /// if it came back to the vertex; otherwise it met a border or was abandoned.
  bool Follow(const Plane& plane, int h, const Bound& bound, Path& path) const;

  /// The best of the curves that leave over a half-edge from the positive to the negative side
  /// (`leaveByDescending`) or the other way round; false if there is none.
  bool FollowShortest(
    const Plane& plane, bool leaveByDescending, const Bound& bound, Path& best) const;

  std::vector<int> VertexOfRank;
  std::vector<int> RankOfVertex;
  std::vector<Eigen::Vector3d> Points; ///< by rank
  std::vector<HalfEdge> HalfEdges;
  std::vector<int> Start;      ///< by half-edge: rank of the vertex it leaves
  std::vector<int> RingOffset; ///< by rank, into Ring
  std::vector<int> Ring;       ///< the half-edges opposite to a vertex in its triangles
  std::vector<int> Across;     ///< by half-edge: the opposite one, -1 on a border
};
}

#endif
