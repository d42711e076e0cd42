// SPDX-License-Identifier: BSD-3-Clause
#include "SliceWalker.h"

namespace marrow
{
namespace
{
// Rounding must not abandon a slice that only just wins.
constexpr double BoundTolerance = 1.0 + 1e-12;
// The bound costs a square root: look at it every so many triangles.
constexpr int StepsPerBoundCheck = 8;
}

struct SliceWalker::Plane
{
  Eigen::Vector3d Origin;
  Eigen::Vector3d Normal;
  int Vertex; ///< rank

  double SignedDistance(const Eigen::Vector3d& point) const
  {
    return this->Normal.dot(point - this->Origin);
  }
};

/// Given up is a walk with Offset + its length + the distance to Target > Perimeter.
struct SliceWalker::Bound
{
  double Perimeter;
  double Offset;
  Eigen::Vector3d Target;
};

struct SliceWalker::Path
{
  double Length = 0.0;
  Eigen::Vector3d Moment =
    Eigen::Vector3d::Zero(); ///< sum of length × (start + end) of the segments
  Eigen::Vector3d End;
  bool Closed = false;
  bool Abandoned = false;

  /// Closed before open before abandoned, then the shorter one.
  bool BetterThan(const Path& other) const
  {
    if (this->Closed != other.Closed)
    {
      return this->Closed;
    }
    if (this->Abandoned != other.Abandoned)
    {
      return !this->Abandoned;
    }
    return this->Length < other.Length;
  }

  void LineTo(const Eigen::Vector3d& point)
  {
    const double length = (point - this->End).norm();
    this->Length += length;
    this->Moment += length * (this->End + point);
    this->End = point;
  }
};

SliceWalker::SliceWalker(const TriangleMesh& mesh)
  : RankOfVertex(mesh.Points.size(), -1)
{
  // Breadth first over vertices, and triangles in the order in which their first vertex comes.
  const int numberOfTriangles = mesh.NumberOfTriangles();
  std::vector<int> triangleOrder;
  std::vector<int> rankOfTriangle(numberOfTriangles, -1);
  triangleOrder.reserve(numberOfTriangles);
  this->VertexOfRank.reserve(mesh.Points.size());
  const auto enqueue = [this](int vertex)
  {
    if (this->RankOfVertex[vertex] < 0)
    {
      this->RankOfVertex[vertex] = static_cast<int>(this->VertexOfRank.size());
      this->VertexOfRank.push_back(vertex);
    }
  };
  std::size_t front = 0;
  for (int seed = 0; seed < mesh.NumberOfVertices(); ++seed)
  {
    if (mesh.Outgoing[seed] < 0)
    {
      continue;
    }
    enqueue(seed);
    for (; front < this->VertexOfRank.size(); ++front)
    {
      const int vertex = this->VertexOfRank[front];
      mesh.ForEachNeighbor(vertex, enqueue);
      mesh.ForEachOutgoing(vertex,
        [&](int h)
        {
          const int triangle = TriangleMesh::TriangleOf(h);
          if (rankOfTriangle[triangle] < 0)
          {
            rankOfTriangle[triangle] = static_cast<int>(triangleOrder.size());
            triangleOrder.push_back(triangle);
          }
        });
    }
  }

  const auto renumbered = [&](int h)
  { return h < 0 ? -1 : 3 * rankOfTriangle[TriangleMesh::TriangleOf(h)] + h % 3; };
  this->HalfEdges.resize(3 * triangleOrder.size());
  this->Start.resize(this->HalfEdges.size());
  this->Across.resize(this->HalfEdges.size());
  for (int h = 0; h < 3 * numberOfTriangles; ++h)
  {
    const int own = renumbered(h);
    const int next = TriangleMesh::Next(h);
    const int previous = TriangleMesh::Previous(h);
    this->HalfEdges[own] = { this->RankOfVertex[mesh.From(previous)],
      renumbered(mesh.Opposite[next]), renumbered(mesh.Opposite[previous]) };
    this->Start[own] = this->RankOfVertex[mesh.From(h)];
    this->Across[own] = renumbered(mesh.Opposite[h]);
  }

  this->Points.reserve(this->VertexOfRank.size());
  this->RingOffset.reserve(this->VertexOfRank.size() + 1);
  this->RingOffset.push_back(0);
  this->Ring.reserve(this->HalfEdges.size());
  for (int vertex : this->VertexOfRank)
  {
    this->Points.push_back(mesh.Points[vertex]);
    mesh.ForEachOutgoing(
      vertex, [&](int h) { this->Ring.push_back(renumbered(TriangleMesh::Next(h))); });
    this->RingOffset.push_back(static_cast<int>(this->Ring.size()));
  }
}

bool SliceWalker::Follow(const Plane& plane, int h, const Bound& bound, Path& path) const
{
  // The ring's half-edge h is left over its opposite, which runs the other way. `start` and `end`
  // are always those of the half-edge over which the next triangle is entered.
  Eigen::Vector3d start = this->Points[this->Start[TriangleMesh::Next(h)]];
  Eigen::Vector3d end = this->Points[this->Start[h]];
  double startDistance = plane.SignedDistance(start);
  double endDistance = plane.SignedDistance(end);
  path.LineTo(start + startDistance / (startDistance - endDistance) * (end - start));
  h = this->Across[h];

  const std::size_t stepLimit = this->HalfEdges.size();
  for (std::size_t step = 1; h >= 0; ++step)
  {
    const HalfEdge& halfEdge = this->HalfEdges[h];
    if (halfEdge.Apex == plane.Vertex)
    {
      path.LineTo(plane.Origin);
      return true;
    }
    const Eigen::Vector3d& apex = this->Points[halfEdge.Apex];
    const double apexDistance = plane.SignedDistance(apex);
    if ((apexDistance >= 0.0) == (startDistance >= 0.0))
    {
      start = apex;
      startDistance = apexDistance;
      h = halfEdge.Next;
    }
    else
    {
      end = apex;
      endDistance = apexDistance;
      h = halfEdge.Previous;
    }
    path.LineTo(start + startDistance / (startDistance - endDistance) * (end - start));

    // The step limit guards against a mesh that is not what it claims to be.
    if (step % StepsPerBoundCheck == 0 &&
      (bound.Offset + path.Length + (path.End - bound.Target).norm() > bound.Perimeter ||
        step > stepLimit))
    {
      path.Abandoned = true;
      return false;
    }
  }
  return false;
}

bool SliceWalker::FollowShortest(
  const Plane& plane, bool leaveByDescending, const Bound& bound, Path& best) const
{
  bool found = false;
  const int last = this->RingOffset[plane.Vertex + 1];
  for (int i = this->RingOffset[plane.Vertex]; i < last; ++i)
  {
    const int h = this->Ring[i];
    const bool startPositive = plane.SignedDistance(this->Points[this->Start[h]]) >= 0.0;
    const bool endPositive =
      plane.SignedDistance(this->Points[this->Start[TriangleMesh::Next(h)]]) >= 0.0;
    if (startPositive == endPositive || startPositive != leaveByDescending)
    {
      continue;
    }
    Path path;
    path.End = plane.Origin;
    path.Closed = this->Follow(plane, h, bound, path);
    if (!found || path.BetterThan(best))
    {
      best = path;
      found = true;
    }
  }
  return found;
}

Slice SliceWalker::Walk(
  int vertex, const Eigen::Vector3d& planeNormal, const SliceBounds& bounds) const
{
  Plane plane;
  plane.Vertex = this->RankOfVertex[vertex];
  Slice slice;
  if (plane.Vertex < 0)
  {
    return slice;
  }
  plane.Origin = this->Points[plane.Vertex];
  plane.Normal = planeNormal;

  // A closed curve leaves the vertex as often over an edge from the positive to the negative side
  // as over one the other way round, so one of the two directions finds it.
  Path path;
  path.End = plane.Origin;
  const bool left =
    this->FollowShortest(plane, true, { bounds.Closed * BoundTolerance, 0.0, plane.Origin }, path);
  if (path.Abandoned || (left && !path.Closed && bounds.Open < 0.0))
  {
    slice.Type = Slice::State::Abandoned;
    return slice;
  }
  if (path.Closed)
  {
    slice.Type = Slice::State::Closed;
  }
  else
  {
    Path back;
    back.End = plane.Origin;
    const bool leftBack = this->FollowShortest(
      plane, false, { bounds.Open * BoundTolerance, path.Length, path.End }, back);
    if (!left && !leftBack)
    {
      return slice;
    }
    if (back.Abandoned)
    {
      slice.Type = Slice::State::Abandoned;
      return slice;
    }
    slice.Type = Slice::State::Open;
    path.LineTo(back.End);
    path.Length += back.Length;
    path.Moment += back.Moment;
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
