// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FlatTriangles_h
#define marrow_FlatTriangles_h

#include "MendedMesh.h"

namespace marrow
{
/// Rids an oriented manifold of triangles without area, those no higher than the rounding of their
/// coordinates, and leaves the surface closed around them: an edge of no length collapses, and takes both
/// its triangles with it; the long edge of a triangle whose corners lie on a line is replaced by the
/// other diagonal of the two triangles there. One that has no such way out stays, unless all of its
/// connected part is like it. Leaves vertices that collapsed without triangles. Returns how many edges
/// were replaced.
int RemoveFlatTriangles(MendedMesh& mesh);
}

#endif
