// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerPlaces.h"

#include "GhostBoundary.h"
#include "LeftoverPlaces.h"

namespace marrow
{
void AlignWithLandmarks(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, const LandmarkParameters& parameters, SkeletonMap& map)
{
  for (std::size_t c = 0; c < match.Chains.size(); ++c)
  {
    const Branch& sourceChain = match.Chains[c].Source;
    const Branch& targetChain = match.Chains[c].Target;
    const auto landmark = MatchGhostBoundaries(
      FindGhostBoundaries(source, sourceChain, parameters.Theta, parameters.Kernel),
      FindGhostBoundaries(target, targetChain, parameters.Theta, parameters.Kernel));
    map.SetAlignment(
      static_cast<int>(c), AlignChains(source, sourceChain, target, targetChain, landmark));
  }
}

void AlignByProfiles(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, SkeletonMap& map)
{
  for (std::size_t c = 0; c < match.Chains.size(); ++c)
  {
    const ChainPair& chain = match.Chains[c];
    map.SetAlignment(
      static_cast<int>(c), AlignChains(source, chain.Source, target, chain.Target, {}));
  }
}

std::vector<SkeletonMap::Place> PlacesByMap(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const SkeletonMap& map)
{
  std::vector<SkeletonMap::Place> places = map.PlacesOfTargetNodes();
  std::vector<bool> isMatched = map.MatchedSourceNodes();
  PlaceLeftovers(source, target, places, isMatched);
  return places;
}
}
