// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_InteriorNodes_h
#define marrow_InteriorNodes_h

#include "Skeleton.h"
#include "TriangleMesh.h"

namespace marrow
{
/// The centre of a ring may lie outside where the part is bent like a shell, or hollow like a cup.
/// Moves such nodes into the middle of the wall, below the nearest part of their own φ.
void MoveNodesInside(Skeleton& skeleton, const TriangleMesh& mesh);
}

#endif
