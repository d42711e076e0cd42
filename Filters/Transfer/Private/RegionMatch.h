// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_RegionMatch_h
#define marrow_RegionMatch_h

#include "BoundaryTransfer.h"
#include "SegmentLoops.h"

#include <utility>
#include <vector>

namespace marrow
{
/// A transferred loop: on the source by its half-edges, on the target by its cut.
struct LoopCut
{
  int Loop = -1; ///< index into the source's loops
  BoundaryTransfer::Cut Cut;
};

/// The regions into which the loops cut both surfaces, and which is which (T:4.5 step 7).
struct RegionMatch
{
  std::vector<int> RegionOfTriangle;       ///< per target triangle
  std::vector<int> SourceRegionOfTriangle; ///< per source triangle
  std::vector<int> SourceRegion;           ///< per target region, -1 if no loop says
};

/// A triangle of the source and one of the target that are on the same part: at the tips of matched
/// limbs.
using TrianglePair = std::pair<int, int>;

/// Cuts both surfaces along the loops and matches the regions that lie on the same side of the same
/// loops. Loops that contradict each other on the target (they cross, or lie in another order than on
/// the source) are taken out of `cuts` one by one, the one that disagrees most first, until all of
/// the rest agree. First of all go those that part the `landmarks` otherwise than on the source: a ring
/// round both legs is none round one.
RegionMatch MatchRegions(const TriangleMesh& source, const TriangleMesh& target,
  const std::vector<SegmentLoop>& loops, const std::vector<TrianglePair>& landmarks,
  std::vector<LoopCut>& cuts);
}

#endif
