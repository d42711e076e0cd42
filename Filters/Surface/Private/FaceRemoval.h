// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FaceRemoval_h
#define marrow_FaceRemoval_h

#include "MendedMesh.h"

#include <vector>

namespace marrow
{
/// Drops the triangles that use a vertex twice. Returns how many.
int RemoveCollapsedTriangles(MendedMesh& mesh);

/// Drops the triangles whose corners another one has already, in whatever direction, and connected
/// parts all of whose triangles lie in the places of those of one before them: shells drawn from both
/// sides. `twinOfCell` gets, per cell with a dropped triangle, the cell of the triangle that stays
/// (other entries are left alone). Returns how many were dropped.
int RemoveTwinTriangles(MendedMesh& mesh, std::vector<int>& twinOfCell);
}

#endif
