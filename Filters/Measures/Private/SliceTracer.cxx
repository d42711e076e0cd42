// SPDX-License-Identifier: BSD-3-Clause
#include "SliceTracer.h"

namespace marrow
{
namespace
{
// Rounding must not abandon a slice that only just wins.
constexpr double BoundTolerance = 1.0 + 1e-12;
}

void SliceTracer::Begin(int rank, const Eigen::Vector3d& planeNormal, const SliceBounds& bounds)
{
  this->Bounds = bounds;
  this->Curve.Vertex = rank;
  this->Curve.Origin = this->Mesh->Points[rank];
  this->Curve.Normal = planeNormal;
  this->Curve.Bound = bounds.Closed * BoundTolerance;
  this->Curve.Offset = 0.0;
  this->Curve.Target = this->Curve.Origin;
  this->Leave = Direction::Descending;
  this->NextOfRing = this->Mesh->RingOffset[rank];
  this->Following = this->Found = this->FoundAhead = this->Refused = false;
}

bool SliceTracer::NextCurve()
{
  if (this->Following)
  {
    this->TakeIn();
  }
  while (!this->LeaveRing())
  {
    if (!this->TurnRound())
    {
      return false;
    }
  }
  return true;
}

void SliceTracer::TakeIn()
{
  this->Following = false;
  SlicePath& path = this->Curve.Path;
  // Whatever the walker looked at on the way: what exceeds the bound is always given up.
  path.Abandoned = path.Abandoned || this->Curve.LeastLength() > this->Curve.Bound;
  if (!this->Found || this->BetterThan(path, this->Best))
  {
    this->Best = path;
    this->Found = true;
  }
}

/// Closed before open before abandoned, then the one that makes the shorter slice.
bool SliceTracer::BetterThan(const SlicePath& path, const SlicePath& other) const
{
  if (path.Abandoned != other.Abandoned)
  {
    return other.Abandoned;
  }
  if (path.Closed != other.Closed)
  {
    return path.Closed;
  }
  return path.Length + Distance(path.End, this->Curve.Target) <
    other.Length + Distance(other.End, this->Curve.Target);
}

/// Follows the plane over the next edge of the ring in the present direction; false if there is none.
bool SliceTracer::LeaveRing()
{
  const SliceMesh& mesh = *this->Mesh;
  SliceCurve& curve = this->Curve;
  const int last = mesh.RingOffset[curve.Vertex + 1];
  for (; this->NextOfRing < last; ++this->NextOfRing)
  {
    // The half-edge is left over its opposite, which runs the other way.
    const int h = mesh.Ring[this->NextOfRing];
    const Eigen::Vector3d& start = mesh.Points[mesh.Start[TriangleMesh::Next(h)]];
    const Eigen::Vector3d& end = mesh.Points[mesh.Start[h]];
    curve.StartDistance = curve.SignedDistance(start);
    curve.EndDistance = curve.SignedDistance(end);
    const bool endPositive = curve.EndDistance >= 0.0;
    if ((curve.StartDistance >= 0.0) == endPositive ||
      endPositive != (this->Leave == Direction::Descending))
    {
      continue;
    }
    curve.HalfEdge = mesh.Across[h];
    curve.Start = start;
    curve.End = end;
    curve.Path = SlicePath();
    curve.Path.End = curve.Origin;
    curve.CrossEdge();
    ++this->NextOfRing;
    this->Following = true;
    return true;
  }
  return false;
}

/// A closed curve leaves the vertex as often over an edge from the positive to the negative side as
/// over one the other way round, so one of the two directions finds it. Only what did not close is
/// followed the other way as well. False if nothing is left to follow.
bool SliceTracer::TurnRound()
{
  if (this->Leave == Direction::Ascending)
  {
    return false;
  }
  if (this->Found && (this->Best.Abandoned || this->Best.Closed || this->Bounds.Open < 0.0))
  {
    this->Refused = !this->Best.Closed || this->Best.Abandoned;
    return false;
  }
  this->FoundAhead = this->Found;
  this->Ahead = this->Found ? this->Best : SlicePath();
  if (!this->FoundAhead)
  {
    this->Ahead.End = this->Curve.Origin;
  }
  this->Found = false;
  this->Leave = Direction::Ascending;
  this->NextOfRing = this->Mesh->RingOffset[this->Curve.Vertex];
  this->Curve.Bound = this->Bounds.Open * BoundTolerance;
  this->Curve.Offset = this->Ahead.Length;
  this->Curve.Target = this->Ahead.End;
  return true;
}

Slice SliceTracer::Result() const
{
  Slice slice;
  if (this->Refused)
  {
    slice.Type = Slice::State::Abandoned;
    return slice;
  }
  SlicePath path = this->Best;
  if (this->Leave == Direction::Descending)
  {
    slice.Type = Slice::State::Closed;
  }
  else if (!this->FoundAhead && !this->Found)
  {
    return slice;
  }
  else
  {
    path = this->Ahead;
    if (this->Found)
    {
      if (this->Best.Abandoned)
      {
        slice.Type = Slice::State::Abandoned;
        return slice;
      }
      path.LineTo(this->Best.End);
      path.Length += this->Best.Length;
      path.Moment += this->Best.Moment;
    }
    else
    {
      path.LineTo(this->Curve.Origin);
    }
    slice.Type = Slice::State::Open;
  }
  if (path.Length <= 0.0)
  {
    slice.Type = Slice::State::None;
    return slice;
  }
  slice.Perimeter = path.Length;
  slice.Center = path.Moment / (2.0 * path.Length);
  return slice;
}
}
