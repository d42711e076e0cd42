// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_InteriorLabels_h
#define marrow_InteriorLabels_h

#include "AnalyzedMesh.h"
#include "GuidedMap.h"
#include "Progress.h"

#include <vector>

namespace marrow
{
/// Per target triangle the regions of pieces that it may belong to; empty allows all.
using AllowedPieces = std::vector<std::vector<int>>;

/// One labelling of all target triangles: the guided map says what a triangle would be, one graph
/// cut settles where the boundaries run. They are drawn to concave places, over a width that the map
/// leaves open (GuidedMap::Width). `allowed[regionOfTriangle[t]]` lists the pieces that triangle t
/// may take; where it lists one, that is the answer.
std::vector<int> LabelInterior(const AnalyzedMesh& target, const GuidedMap& map,
  const std::vector<int>& regionOfTriangle, const AllowedPieces& allowed, const Progress& progress);
}

#endif
