// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FaceOrientation_h
#define marrow_FaceOrientation_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
struct OrientationChanges
{
  std::vector<char> IsTurned; ///< per triangle
  int CutEdges = 0;
};

/// Turns triangles so that partners (Opposite, as PairSheets leaves it) run against each other, and
/// each connected part so that its normals point outwards: its volume, seen from the middle of its
/// border if it has one, is positive. A part without an inside, such as a sheet, keeps the side that
/// most of its area has. A part that cannot be oriented is cut at as few and as sharp edges as a
/// spanning tree over its flattest edges leaves.
OrientationChanges OrientTriangles(TriangleMesh& mesh);
}

#endif
