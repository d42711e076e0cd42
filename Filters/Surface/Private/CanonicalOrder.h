// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CanonicalOrder_h
#define marrow_CanonicalOrder_h

#include "PolygonMesh.h"

#include <vector>

namespace marrow
{
/// A mesh whose points and polygons stand in an order that its geometry alone gives, seen from its canonical
/// frame. What mends it (which of two equal points stays, where a hole is closed first) then does the same
/// however the file was ordered and the mesh placed.
struct CanonicalPolygons
{
  PolygonMesh Mesh;                 ///< in the coordinates of the input
  std::vector<int> OriginalPoint;   ///< per point
  std::vector<int> OriginalPolygon; ///< per polygon
};

/// O(n log n). For a mesh that passed CheckInput.
CanonicalPolygons InCanonicalOrder(const PolygonMesh& input);
}

#endif
