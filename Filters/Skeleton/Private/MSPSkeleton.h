// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MSPSkeleton_h
#define marrow_MSPSkeleton_h

#include "NodeMeasures.h"
#include "Progress.h"
#include "Skeleton.h"
#include "TriangleMesh.h"

namespace marrow
{
/// The MSP skeleton of a manifold mesh (correspondence paper, section 5): shrink, collapse, prune,
/// even out, centre. Several components give several skeletons in one. Returns a skeleton without
/// nodes when `progress` asks to stop.
/// `finestArea` is the least share of the mesh's area of a limb (see PruneSpurs); `spacing` the
/// distance of the nodes along a branch, in mesh units.
Skeleton ComputeMSPSkeleton(const TriangleMesh& mesh, const VertexMeasures& measures,
  double finestArea, double spacing, const Progress& progress);
}

#endif
