// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_NearestTriangles_h
#define marrow_NearestTriangles_h

#include "Simplification.h"

namespace marrow
{
/// Gives every old triangle the nearest new one, found along the surface, and every old vertex one that is near.
void FindNearest(const TriangleMesh& mesh, SimplifiedMesh& simplified);
}

#endif
