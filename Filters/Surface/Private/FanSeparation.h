// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FanSeparation_h
#define marrow_FanSeparation_h

#include "MendedMesh.h"

namespace marrow
{
/// Gives every fan of triangles its own vertex, at the same place: where bodies touch in a point, and
/// along the edges at which sheets were parted. The first fan keeps the vertex. Then no two edges but
/// partners join the same two vertices: where sheets that were parted at an edge are still joined at
/// both its ends, all but one get a vertex in the middle of the edge. Needs partners that run against
/// each other; leaves an oriented manifold with Opposite and Outgoing filled. Returns how many
/// vertices were added.
int SeparateFans(MendedMesh& mesh);
}

#endif
