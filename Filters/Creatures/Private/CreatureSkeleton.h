// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CreatureSkeleton_h
#define marrow_CreatureSkeleton_h

#include "ImplicitCreature.h"
#include "Skeleton.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// A creature's centre lines as one graph: limbs share the node of the joint that they sit on.
struct CreatureSkeleton
{
  Skeleton Graph;                             ///< Radius is that of the centre line; φ is empty
  std::vector<std::vector<int>> NodesOfLimbs; ///< in order along the limb
};

CreatureSkeleton MakeCreatureSkeleton(const Creature& creature, const ImplicitCreature& implicit);

/// Whether parts that are far from each other along the skeleton keep clear of each other in space,
/// so that the smooth union does not weld them. Where they are close in the rest pose already, next
/// to a joint, they may not come closer.
bool HasClearance(
  const CreatureSkeleton& posed, const CreatureSkeleton& resting, const Creature& creature);

/// Fills φ with the vertices of the nearest limb's nearest node, sets Radius and MeshDiagonal,
/// takes regular nodes with an empty φ out (they lie inside the part that a limb sits on), and
/// extracts the branches.
Skeleton AssociateVertices(
  const CreatureSkeleton& skeleton, const ImplicitCreature& implicit, const TriangleMesh& mesh);
}

#endif
