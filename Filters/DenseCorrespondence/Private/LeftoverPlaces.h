// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LeftoverPlaces_h
#define marrow_LeftoverPlaces_h

#include "AnalyzedMesh.h"
#include "SkeletonMap.h"

#include <vector>

namespace marrow
{
/// Finds what neither skeleton could match but lies in the same place: the backs of two chairs, one
/// with a loop more than the other, still stand behind the seat.
///
/// Every connected part of the target's skeleton without a partner is carried by the similarity that
/// fits the matched nodes best, those near the part counting most. Where its nodes come to lie near
/// nodes of the source without a partner, they take their place, and those are marked in `isMatched`
/// (per source node). Parts that find nothing are left as they are.
void PlaceLeftovers(const AnalyzedMesh& source, const AnalyzedMesh& target,
  std::vector<SkeletonMap::Place>& places, std::vector<bool>& isMatched);
}

#endif
