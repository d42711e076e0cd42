// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BoundaryPairs_h
#define marrow_BoundaryPairs_h

#include "AnalyzedMesh.h"
#include "GuidedMap.h"
#include "RegionMatch.h"
#include "SegmentLoops.h"
#include "SegmentationTransfer.h"

#include <vector>

namespace marrow
{
/// Every loop of the source with its partner on the target. A loop that was transferred by its
/// branch brings its own; for the others the boundary between the same two pieces on the labelled
/// target is taken (of several the one that the guided map brings nearest) and corresponding points
/// sit at equal fractions of the length, from the start that fits best.
std::vector<BoundaryPair> PairBoundaries(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const SegmentPieces& pieces, const std::vector<SegmentLoop>& loops,
  const std::vector<LoopCut>& cuts, const GuidedMap& map,
  const std::vector<int>& pieceOfTargetTriangle);
}

#endif
