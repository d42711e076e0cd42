// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TransferredPieces_h
#define marrow_TransferredPieces_h

#include "AnalyzedMesh.h"
#include "SegmentLoops.h"

#include <vector>

namespace marrow
{
/// Pieces that lie for the most part on matched branches, or hold a part of what is matched: a matched
/// node whose φ lies for the most part in them. (A patch on a limb holds no node; a body is one even
/// if most of its surface belongs to a branch of its own that has no partner.) All of them if nothing is matched, or no piece qualifies.
std::vector<bool> TransferredPieces(
  const AnalyzedMesh& source, const SegmentPieces& pieces, const std::vector<bool>& isNodeMatched);
}

#endif
