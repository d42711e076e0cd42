// SPDX-License-Identifier: BSD-3-Clause
#include "MinimumSlicePerimeter.h"

#include "Constants.h"
#include "ParallelFor.h"
#include "SharedProgress.h"
#include "SliceLanes.h"
#include "SliceMesh.h"
#include "SliceTracer.h"
#include "SurfaceMeasures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
// A vertex tries first the plane that won at a neighbour, of the same block and done by then. The size
// is fixed, so that the order of trying does not depend on the number of threads.
constexpr int VerticesPerBlock = 512;
constexpr int VerticesPerReport = 64;
// Every thread has some of these to do.
constexpr int BlocksPerLoop = 16;

/// The best slice of a vertex so far.
struct Best
{
  Slice BestSlice;
  int PlaneIndex = -1;
  Eigen::Vector3d Normal = Eigen::Vector3d::Zero();

  void Offer(const Slice& slice, int index, const Eigen::Vector3d& normal)
  {
    if (slice.Type != Slice::State::Closed && slice.Type != Slice::State::Open)
    {
      return;
    }
    const bool closed = slice.Type == Slice::State::Closed;
    const bool bestIsClosed = this->BestSlice.Type == Slice::State::Closed;
    const bool better = this->PlaneIndex < 0 || (closed && !bestIsClosed) ||
      (closed == bestIsClosed &&
        (slice.Perimeter < this->BestSlice.Perimeter ||
          (slice.Perimeter == this->BestSlice.Perimeter && index < this->PlaneIndex)));
    if (better)
    {
      this->BestSlice = slice;
      this->PlaneIndex = index;
      this->Normal = normal;
    }
  }

  SliceBounds Bounds() const
  {
    SliceBounds bounds;
    if (this->BestSlice.Type == Slice::State::Closed)
    {
      bounds.Closed = this->BestSlice.Perimeter;
      bounds.Open = -1.0;
    }
    else if (this->BestSlice.Type == Slice::State::Open)
    {
      bounds.Open = this->BestSlice.Perimeter;
    }
    return bounds;
  }
};

/// The planes that are tried at every vertex, by the angle from its axis.
struct PlaneAngles
{
  explicit PlaneAngles(int numberOfSlices)
    : Step(Pi / numberOfSlices)
  {
    for (int index = 0; index < numberOfSlices; ++index)
    {
      this->Cosine.push_back(std::cos(index * this->Step));
      this->Sine.push_back(std::sin(index * this->Step));
    }
  }

  int Count() const { return static_cast<int>(this->Cosine.size()); }

  double Step;
  std::vector<double> Cosine;
  std::vector<double> Sine;
};

/// The search for the least slice of one vertex, from plane to plane.
class PlaneSearch
{
public:
  PlaneSearch(const SliceMesh& mesh, const PlaneAngles& angles)
    : Angles(&angles)
    , Tracer(mesh)
  {
  }

  /// `hint` is the plane normal that won at a neighbour, or zero.
  void Begin(int rank, const Eigen::Vector3d& normal, const Eigen::Vector3d& axis,
    const Eigen::Vector3d& hint)
  {
    this->Rank = rank;
    this->Axis = axis;
    this->Side = normal.cross(axis);
    this->First = 0;
    if (hint.squaredNorm() > 0.0)
    {
      const double angle = std::atan2(this->Side.dot(hint), this->Axis.dot(hint));
      this->First = static_cast<int>(std::lround(angle / this->Angles->Step));
    }
    this->Tried = 0;
    this->Found = Best();
    this->BeginPlane();
  }

  /// The next curve to be followed; nullptr when all planes have been tried.
  SliceCurve* NextCurve()
  {
    while (!this->Tracer.NextCurve())
    {
      this->Found.Offer(this->Tracer.Result(), this->Index, this->Tracer.Curve.Normal);
      if (++this->Tried == this->Angles->Count())
      {
        return nullptr;
      }
      this->BeginPlane();
    }
    return &this->Tracer.Curve;
  }

  bool IsUnderWay() const { return this->Rank >= 0; }
  int GetRank() const { return this->Rank; }
  const Best& Result() const { return this->Found; }

private:
  /// From the likeliest plane outwards: 0, +1, -1, +2, ...
  void BeginPlane()
  {
    const int count = this->Angles->Count();
    const int turn = this->Tried % 2 == 1 ? (this->Tried + 1) / 2 : -this->Tried / 2;
    this->Index = ((this->First + turn) % count + count) % count;
    const Eigen::Vector3d normal =
      this->Angles->Cosine[this->Index] * this->Axis + this->Angles->Sine[this->Index] * this->Side;
    this->Tracer.Begin(this->Rank, normal, this->Found.Bounds());
  }

  const PlaneAngles* Angles;
  SliceTracer Tracer;
  int Rank = -1;
  Eigen::Vector3d Axis = Eigen::Vector3d::Zero();
  Eigen::Vector3d Side = Eigen::Vector3d::Zero();
  int First = 0;
  int Tried = 0;
  int Index = 0;
  Best Found;
};

/// The least slices of all vertices, block by block.
class SliceSearch
{
public:
  SliceSearch(const TriangleMesh& mesh, int numberOfSlices, SliceField& field)
    : Mesh(mesh)
    , Angles(numberOfSlices)
    , Layout(mesh)
    , Normals(mesh.VertexNormals())
    , Axes(LeastBendingDirections(mesh, this->Normals))
    , Field(field)
    , Known(mesh.Points.size(), 0)
  {
  }

  int NumberOfBlocks() const
  {
    return (static_cast<int>(this->Layout.VertexOfRank.size()) + VerticesPerBlock - 1) /
      VerticesPerBlock;
  }

  /// Returns early when `progress` tells to stop.
  void DoBlock(int block, SharedProgress& progress)
  {
    const int begin = block * VerticesPerBlock;
    const int end =
      std::min(begin + VerticesPerBlock, static_cast<int>(this->Layout.VertexOfRank.size()));
    const double shareOfReport =
      static_cast<double>(VerticesPerReport) / this->Layout.VertexOfRank.size();
    int next = begin;
    std::vector<PlaneSearch> searches(SliceLaneCount, PlaneSearch(this->Layout, this->Angles));
    FollowInLanes(this->Layout,
      [&](int lane) -> SliceCurve*
      {
        PlaneSearch& search = searches[lane];
        for (;;)
        {
          if (search.IsUnderWay())
          {
            if (SliceCurve* curve = search.NextCurve())
            {
              return curve;
            }
            this->Keep(search);
          }
          if (next % VerticesPerReport == 0 && next < end && !progress.Add(shareOfReport))
          {
            next = end;
          }
          if (!this->BeginNext(search, begin, end, next))
          {
            return nullptr;
          }
        }
      });
  }

  std::vector<char>& GetKnown() { return this->Known; }

private:
  /// Begins the search of the next vertex of the block; false if none is left.
  bool BeginNext(PlaneSearch& search, int begin, int end, int& next) const
  {
    while (next < end)
    {
      const int rank = next++;
      const int v = this->Layout.VertexOfRank[rank];
      if (this->Normals[v].squaredNorm() == 0.0)
      {
        continue;
      }
      Eigen::Vector3d hint = Eigen::Vector3d::Zero();
      int hintRank = -1;
      this->Mesh.ForEachNeighbor(v,
        [&](int n)
        {
          const int neighborRank = this->Layout.RankOfVertex[n];
          if (neighborRank >= begin && neighborRank < end && neighborRank > hintRank &&
            this->Known[n])
          {
            hintRank = neighborRank;
            hint = this->Field.Normal[n];
          }
        });
      search.Begin(rank, this->Normals[v], this->Axes[v], hint);
      return true;
    }
    return false;
  }

  void Keep(const PlaneSearch& search)
  {
    const Best& best = search.Result();
    if (best.PlaneIndex < 0)
    {
      return;
    }
    const int v = this->Layout.VertexOfRank[search.GetRank()];
    this->Known[v] = 1;
    this->Field.Perimeter[v] = best.BestSlice.Perimeter;
    this->Field.Center[v] = best.BestSlice.Center;
    this->Field.Normal[v] = best.Normal;
    this->Field.Valid[v] = best.BestSlice.Type == Slice::State::Closed;
  }

  const TriangleMesh& Mesh;
  PlaneAngles Angles;
  SliceMesh Layout;
  std::vector<Eigen::Vector3d> Normals;
  std::vector<Eigen::Vector3d> Axes;
  SliceField& Field;
  std::vector<char> Known;
};

void FillFromNeighbors(const TriangleMesh& mesh, std::vector<char>& known, SliceField& field)
{
  std::vector<int> missing;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (!known[v] && mesh.Outgoing[v] >= 0)
    {
      missing.push_back(v);
    }
  }
  // Layer by layer, each from the layers before it alone.
  while (!missing.empty())
  {
    std::vector<int> filled;
    std::vector<int> rest;
    for (int v : missing)
    {
      int count = 0;
      double perimeter = 0.0;
      Eigen::Vector3d center = Eigen::Vector3d::Zero();
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      mesh.ForEachNeighbor(v,
        [&](int n)
        {
          if (known[n])
          {
            ++count;
            perimeter += field.Perimeter[n];
            center += field.Center[n];
            normal += normal.dot(field.Normal[n]) < 0.0 ? -field.Normal[n] : field.Normal[n];
          }
        });
      if (count == 0)
      {
        rest.push_back(v);
        continue;
      }
      filled.push_back(v);
      field.Perimeter[v] = perimeter / count;
      field.Center[v] = center / count;
      field.Normal[v] = normal.normalized();
    }
    if (filled.empty())
    {
      break;
    }
    for (int v : filled)
    {
      known[v] = 1;
    }
    missing.swap(rest);
  }
}
}

bool ComputeMinimumSlicePerimeter(
  const TriangleMesh& mesh, int numberOfSlices, SliceField& field, const Progress& progress)
{
  const int numberOfVertices = mesh.NumberOfVertices();
  field.Perimeter.assign(numberOfVertices, 0.0);
  field.Center = mesh.Points;
  field.Normal.assign(numberOfVertices, Eigen::Vector3d::Zero());
  field.Valid.assign(numberOfVertices, 0);

  SliceSearch search(mesh, numberOfSlices, field);
  const int numberOfBlocks = search.NumberOfBlocks();
  SharedProgress shared(progress);
  for (int block = 0; block < numberOfBlocks; block += BlocksPerLoop)
  {
    ParallelFor(block, std::min(block + BlocksPerLoop, numberOfBlocks),
      [&](int first, int last)
      {
        for (int b = first; b < last; ++b)
        {
          search.DoBlock(b, shared);
        }
      });
    if (!shared.Add(0.0))
    {
      return false;
    }
  }
  FillFromNeighbors(mesh, search.GetKnown(), field);
  return Report(progress, 1.0);
}
}
