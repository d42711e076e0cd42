// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CreatureSegments_h
#define marrow_CreatureSegments_h

#include "ImplicitCreature.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The segment of every triangle: that of the limb whose own surface is nearest, so the cut between
/// two limbs is the crease where they meet. Single teeth of a cut are filed off and what is not
/// connected to the bulk of its segment goes to a neighbour.
std::vector<int> SegmentCreature(
  const Creature& creature, const ImplicitCreature& implicit, const TriangleMesh& mesh);
}

#endif
