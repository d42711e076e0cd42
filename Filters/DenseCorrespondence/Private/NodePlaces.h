// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_NodePlaces_h
#define marrow_NodePlaces_h

#include "AnalyzedMesh.h"
#include "ChainAlignment.h"
#include "MatchedSkeletons.h"
#include "SkeletonMap.h"

#include <vector>

namespace marrow
{
/// Aligns all matched chains by what the surface is like along them.
std::vector<ChainAlignment> AlignByProfiles(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const MatchedSkeletons& match);

/// Where the nodes of two skeletons lie on each other.
struct NodePlaces
{
  std::vector<SkeletonMap::Place> OfTarget; ///< per node of the target
  std::vector<bool> IsSourceMatched;        ///< per node of the source
};

/// By the map, and of parts without a partner by where they lie (PlaceLeftovers).
NodePlaces PlaceNodes(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const SkeletonMap& map);
}

#endif
