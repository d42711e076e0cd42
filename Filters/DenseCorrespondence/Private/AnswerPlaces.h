// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnswerPlaces_h
#define marrow_AnswerPlaces_h

#include "AnalyzedMesh.h"
#include "MatchedSkeletons.h"
#include "SkeletonMap.h"

#include <vector>

namespace marrow
{
/// What makes a change of thickness along a branch a landmark of its alignment (FindGhostBoundaries).
struct LandmarkParameters
{
  double Theta = 1.5;   ///< how far it stands out
  double Kernel = 0.05; ///< smoothing of the profile, of the chain's length
};

/// Aligns all matched chains by what the surface is like along them, with landmarks.
void AlignWithLandmarks(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, const LandmarkParameters& parameters, SkeletonMap& map);

/// The same by the profiles alone, which a coarse mesh has as well.
void AlignByProfiles(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, SkeletonMap& map);

/// One place per node of the target, those included that are found by where they lie (PlaceLeftovers).
std::vector<SkeletonMap::Place> PlacesByMap(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const SkeletonMap& map);
}

#endif
