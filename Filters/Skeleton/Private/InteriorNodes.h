// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_InteriorNodes_h
#define marrow_InteriorNodes_h

#include "Skeleton.h"
#include "TriangleMesh.h"

namespace marrow
{
/// How often the surface winds round a point: 1 inside a closed mesh, 0 outside, in between near the
/// holes of an open one (Jacobson, Kavan and Sorkine 2013). O(triangles).
double WindingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point);

/// The centre of a ring may lie outside where the part is bent like a shell, or hollow like a cup.
/// Moves such nodes into the middle of the wall, below the nearest part of their own φ.
void MoveNodesInside(Skeleton& skeleton, const TriangleMesh& mesh);
}

#endif
