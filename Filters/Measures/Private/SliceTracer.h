// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceTracer_h
#define marrow_SliceTracer_h

#include "SliceMesh.h"

#include <Eigen/Core>

#include <cmath>
#include <limits>

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

/// The sums are spelled out so that every processor and every library adds them up in one order: walks
/// by themselves and in lanes have the same bits.
inline double Dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
inline double Distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d way = b - a;
  return std::sqrt(Dot(way, way));
}

/// A line from a vertex along the surface, in a plane.
struct SlicePath
{
  double Length = 0.0;
  Eigen::Vector3d Moment =
    Eigen::Vector3d::Zero(); ///< sum of length × (start + end) of the segments
  Eigen::Vector3d End = Eigen::Vector3d::Zero();
  bool Closed = false;
  bool Abandoned = false;

  void LineTo(const Eigen::Vector3d& point)
  {
    const double length = Distance(this->End, point);
    this->Length += length;
    this->Moment += length * (this->End + point);
    this->End = point;
  }
};

/// A curve that has just left the ring of its vertex, and what a walker needs to follow it.
struct SliceCurve
{
  int Vertex = -1; ///< rank; the curve is closed when it comes back here
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d Normal = Eigen::Vector3d::Zero();
  /// The half-edge over which the next triangle is entered, -1 at a border; its ends and the signed
  /// distances of these from the plane. A walk may change them.
  int HalfEdge = -1;
  Eigen::Vector3d Start = Eigen::Vector3d::Zero();
  Eigen::Vector3d End = Eigen::Vector3d::Zero();
  double StartDistance = 0.0;
  double EndDistance = 0.0;
  /// Given up is a path with Offset + its length + the distance to Target > Bound.
  double Bound = std::numeric_limits<double>::infinity();
  double Offset = 0.0;
  Eigen::Vector3d Target = Eigen::Vector3d::Zero();

  SlicePath Path;

  /// On which side a point lies is decided by the sign of this alone, zero counting as positive.
  double SignedDistance(const Eigen::Vector3d& point) const
  {
    return Dot(this->Normal, point - this->Origin);
  }
  void CrossEdge()
  {
    this->Path.LineTo(this->Start +
      this->StartDistance / (this->StartDistance - this->EndDistance) * (this->End - this->Start));
  }
  /// The path's length with the straight way that is left to it at least.
  double LeastLength() const
  {
    return this->Offset + this->Path.Length + Distance(this->Target, this->Path.End);
  }
};

/// Makes a slice of the curves in which its plane leaves the vertex. The curves are followed by others,
/// one at a time or several slices at once:
///
///     tracer.Begin(rank, normal, bounds);
///     while (tracer.NextCurve())
///     {
///       (follow tracer.Curve)
///     }
///     tracer.Result()
///
/// Which side of the plane a vertex p lies on is decided by the sign of n · (p - q) alone and by the
/// very same expression at the start and along the way: the edges with ends on either side then form
/// closed cycles of triangles whatever the rounding, so that a walk on a closed mesh always comes home.
///
/// Where the plane leaves the vertex in more than two directions (a figure of eight), the least loop
/// counts. A walk is given up as soon as the length so far plus the straight way back exceeds the
/// bound, which by the triangle inequality the slice then does as well: the pruning is exact.
class SliceTracer
{
public:
  explicit SliceTracer(const SliceMesh& mesh)
    : Mesh(&mesh)
  {
  }

  void Begin(int rank, const Eigen::Vector3d& planeNormal, const SliceBounds& bounds);
  /// Takes in the curve that has been followed, and makes the next one; false if there is none.
  bool NextCurve();
  Slice Result() const;

  SliceCurve Curve;

private:
  enum class Direction
  {
    Descending, ///< over an edge from the positive to the negative side
    Ascending
  };

  bool BetterThan(const SlicePath& path, const SlicePath& other) const;
  void TakeIn();
  bool LeaveRing();
  bool TurnRound();

  const SliceMesh* Mesh;
  SliceBounds Bounds;
  Direction Leave = Direction::Descending;
  int NextOfRing = 0;
  bool Following = false;
  bool Found = false; ///< a curve in the present direction
  bool Refused = false;
  SlicePath Best; ///< of the present direction
  bool FoundAhead = false;
  SlicePath Ahead; ///< the best that descends, if it did not close
};
}

#endif
