// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MendedMesh_h
#define marrow_MendedMesh_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// Triangles on their way from the polygons of a file to an oriented manifold. The steps of mending
/// work on it one after the other; each leaves it as it is where there is nothing to mend.
struct MendedMesh
{
  /// Opposite is filled by PairSheets and kept by the steps after it.
  TriangleMesh Mesh;
  std::vector<int> CellOfTriangle; ///< the polygon a triangle came from; -1: it fills a hole
  std::vector<int> PointOfVertex;  ///< the input point at a vertex's place

  /// Keeps the triangles that are marked, in their order. Opposite is not kept.
  void KeepTriangles(const std::vector<char>& keep);
};
}

#endif
