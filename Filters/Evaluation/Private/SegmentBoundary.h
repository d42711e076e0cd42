// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentBoundary_h
#define marrow_SegmentBoundary_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The edges between faces of two segments, and the vertices on them.
struct SegmentBoundary
{
  std::vector<int> HalfEdges; ///< one of the two of each edge
  std::vector<int> Vertices;  ///< ascending

  SegmentBoundary(const TriangleMesh& mesh, const std::vector<int>& segments);
};

/// Per vertex the length of the shortest path along edges to any of `sources`, infinite where there
/// is none. O(n log n).
std::vector<double> EdgeDistances(const TriangleMesh& mesh, const std::vector<int>& sources);

/// How far apart two boundaries are.
struct BoundaryDistances
{
  /// Mean over the vertices of both boundaries of the distance to the other boundary, mesh units.
  double VertexMean = 0.0;
  /// Mean over the length of both boundaries, mesh units.
  double LengthMean = 0.0;
};

/// Both ways. 0 where neither has a boundary, NaN where only one has, or both have theirs on
/// different components; elsewhere, vertices from which the other cannot be reached do not count.
BoundaryDistances MeasureBoundaryDistances(
  const TriangleMesh& mesh, const std::vector<int>& segments, const std::vector<int>& reference);
}

#endif
