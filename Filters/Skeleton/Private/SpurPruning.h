// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SpurPruning_h
#define marrow_SpurPruning_h

#include "Skeleton.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// Removes the terminal branches that are no limb, least significant first, and gives their φ to the
/// node they hang on. Returns for each vertex the number of the removed limb that it belongs to, -1 for
/// none: such a vertex counts for its new node, whose place it says nothing about. To a limb belong also
/// those of the junction's own φ whose `shrunk` position is nearest to it, and the spurs it had itself.
///
/// A limb stands out of the body by more than its own thickness, and it is a part of the surface worth
/// a name. The significance of a terminal branch is the lesser of
///  - its prominence over 1.25: the arc length from its junction to its farthest tip, less the radius
///    of the junction, over the mean radius MSP / 2π of what stands out, and
///  - its share of the mesh's area over `finestArea`.
/// Both are ratios: neither units nor resolution matter. Where to stop is not at 1 sharp but in the
/// widest gap of the significances within a factor 1.6 of it, so that alike branches (the toes of a
/// foot) stay or go together.
std::vector<int> PruneSpurs(Skeleton& skeleton, const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& shrunk, const std::vector<double>& msp, double finestArea);
}

#endif
