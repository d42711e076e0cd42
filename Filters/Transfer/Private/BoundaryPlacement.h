// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BoundaryPlacement_h
#define marrow_BoundaryPlacement_h

#include "AnalyzedMesh.h"
#include "BoundaryTransfer.h"
#include "GuidedMap.h"
#include "SegmentLoops.h"

namespace marrow
{
/// How far a cut of the target and the guided map contradict each other: the share of the covering
/// region's area that lies on one side of the cut but, by the map, belongs to pieces on the other.
/// 0 where the two run together, one half where the map has no change in the region at all. Of a loop
/// that does not separate the source (round a handle), only the two pieces that meet there have a side.
double Disagreement(const AnalyzedMesh& source, const AnalyzedMesh& target, const SegmentLoop& loop,
  const BoundaryTransfer::Cut& cut, const SegmentPieces& pieces, const GuidedMap& map);
}

#endif
