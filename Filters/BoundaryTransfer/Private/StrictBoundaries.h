// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_StrictBoundaries_h
#define marrow_StrictBoundaries_h

#include "AnalyzedMesh.h"
#include "BoundaryTransfer.h"
#include "Progress.h"
#include "SegmentLoops.h"

#include <vector>

namespace marrow
{
/// A loop of the source that was carried over: by its index, and as a cut of the target.
struct CarriedLoop
{
  int Loop = -1;
  BoundaryTransfer::Cut Cut;
};

/// Carries the loops between transferred pieces that enclose one matched branch, each by the frames of that
/// branch; as far as it got if `progress` asks to stop.
std::vector<CarriedLoop> CarryLoops(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, const SkeletonMap& map,
  const BoundaryTransfer::Parameters& parameters, const std::vector<SegmentLoop>& loops,
  const std::vector<bool>& isTransferred, const Progress& progress);

/// The pieces as only the carried loops part them: pieces on both sides of any other loop become one,
/// under the label of the largest.
SegmentPieces MergePieces(const SegmentPieces& pieces, const std::vector<SegmentLoop>& loops,
  const std::vector<CarriedLoop>& carried);

/// Per target triangle the pieces that the carried curves keep out of it: in the covering region of a
/// curve, those that lie on the other side of the source's loop.
std::vector<std::vector<int>> PiecesBeyondCurves(const TriangleMesh& source,
  const SegmentPieces& pieces, const std::vector<SegmentLoop>& loops,
  const std::vector<CarriedLoop>& carried, int numberOfTargetTriangles);
}

#endif
