// SPDX-License-Identifier: BSD-3-Clause
#include "MinimumSlicePerimeter.h"

#include "Constants.h"
#include "ParallelFor.h"
#include "SharedProgress.h"
#include "SliceWalker.h"
#include "SurfaceMeasures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
// Vertices of a block are done one after another, each from its neighbour's result. The size is
// fixed, so that the order of trying does not depend on the number of threads.
constexpr int VerticesPerBlock = 128;
// Every thread has some of these to do.
constexpr int BlocksPerLoop = 32;

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

/// All slices of one vertex. `hint` is the plane normal that won at a neighbour, or zero.
Best LeastSlice(const SliceWalker& walker, int vertex, const Eigen::Vector3d& normal,
  const Eigen::Vector3d& axis, const Eigen::Vector3d& hint, int numberOfSlices)
{
  Best best;
  const Eigen::Vector3d side = normal.cross(axis);
  const double step = Pi / numberOfSlices;
  int first = 0;
  if (hint.squaredNorm() > 0.0)
  {
    const double angle = std::atan2(side.dot(hint), axis.dot(hint));
    first = static_cast<int>(std::lround(angle / step));
  }
  // From the likeliest plane outwards: 0, +1, -1, +2, ...
  for (int i = 0; i < numberOfSlices; ++i)
  {
    const int turn = i % 2 == 1 ? (i + 1) / 2 : -i / 2;
    const int index = ((first + turn) % numberOfSlices + numberOfSlices) % numberOfSlices;
    const Eigen::Vector3d planeNormal =
      std::cos(index * step) * axis + std::sin(index * step) * side;
    best.Offer(walker.Walk(vertex, planeNormal, best.Bounds()), index, planeNormal);
  }
  return best;
}

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

  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  const std::vector<Eigen::Vector3d> axes = LeastBendingDirections(mesh, normals);
  const SliceWalker walker(mesh);
  const std::vector<int>& order = walker.Order();
  std::vector<char> known(numberOfVertices, 0);

  const int numberOfBlocks =
    (static_cast<int>(order.size()) + VerticesPerBlock - 1) / VerticesPerBlock;
  SharedProgress shared(progress);
  const auto doBlocks = [&](int firstBlock, int lastBlock)
  {
    for (int block = firstBlock; block < lastBlock; ++block)
    {
      if (!shared.Add(1.0 / numberOfBlocks))
      {
        return;
      }
      const int begin = block * VerticesPerBlock;
      const int end = std::min(begin + VerticesPerBlock, static_cast<int>(order.size()));
      for (int rank = begin; rank < end; ++rank)
      {
        const int v = order[rank];
        if (normals[v].squaredNorm() == 0.0)
        {
          continue;
        }
        Eigen::Vector3d hint = Eigen::Vector3d::Zero();
        int hintRank = -1;
        mesh.ForEachNeighbor(v,
          [&](int n)
          {
            const int neighborRank = walker.RankOf(n);
            if (neighborRank >= begin && neighborRank < rank && neighborRank > hintRank && known[n])
            {
              hintRank = neighborRank;
              hint = field.Normal[n];
            }
          });
        const Best best = LeastSlice(walker, v, normals[v], axes[v], hint, numberOfSlices);
        if (best.PlaneIndex >= 0)
        {
          known[v] = 1;
          field.Perimeter[v] = best.BestSlice.Perimeter;
          field.Center[v] = best.BestSlice.Center;
          field.Normal[v] = best.Normal;
          field.Valid[v] = best.BestSlice.Type == Slice::State::Closed;
        }
      }
    }
  };
  for (int block = 0; block < numberOfBlocks; block += BlocksPerLoop)
  {
    ParallelFor(block, std::min(block + BlocksPerLoop, numberOfBlocks), doBlocks);
    if (!shared.Add(0.0))
    {
      return false;
    }
  }
  FillFromNeighbors(mesh, known, field);
  return Report(progress, 1.0);
}
}
