// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BoundaryPairs_h
#define marrow_BoundaryPairs_h

#include "AnalyzedMesh.h"
#include "DenseMap.h"
#include "MatchedSkeletons.h"
#include "SegmentLoops.h"
#include "SegmentationTransfer.h"

#include <vector>

namespace marrow
{
/// A pair for every loop of the source, which has no partner yet.
std::vector<BoundaryPair> PairsOfLoops(const AnalyzedMesh& source, const MatchedSkeletons& match,
  const SegmentPieces& pieces, const std::vector<SegmentLoop>& loops);

/// Finds the partners: the boundaries between the same two pieces on the labelled target, of several
/// the one that the dense map brings nearest. Corresponding points sit at equal fractions of the
/// length, from the start that fits best.
void FindTargetBoundaries(const AnalyzedMesh& target, const std::vector<SegmentLoop>& loops,
  const DenseMap& map, const std::vector<int>& pieceOfTargetTriangle,
  std::vector<BoundaryPair>& pairs);
}

#endif
