// SPDX-License-Identifier: BSD-3-Clause
#include "NodePlaces.h"

#include "LeftoverPlaces.h"

namespace marrow
{
std::vector<ChainAlignment> AlignByProfiles(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const MatchedSkeletons& match)
{
  std::vector<ChainAlignment> alignments;
  for (const ChainPair& chain : match.Chains)
  {
    alignments.push_back(AlignChains(source, chain.Source, target, chain.Target, {}));
  }
  return alignments;
}

NodePlaces PlaceNodes(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const SkeletonMap& map)
{
  NodePlaces places{ map.PlacesOfTargetNodes(), map.MatchedSourceNodes() };
  PlaceLeftovers(source, target, places.OfTarget, places.IsSourceMatched);
  return places;
}
}
