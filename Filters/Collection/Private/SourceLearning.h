// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SourceLearning_h
#define marrow_SourceLearning_h

#include "CollectionGraph.h"
#include "LabelShares.h"
#include "Progress.h"

#include <vector>

namespace marrow
{
/// How well a labelled mesh is labelled when its labels are held back: the share of its area with the right
/// label, by the vote alone and with what was learnt from the others.
struct HeldOutAccuracy
{
  int Mesh = -1; ///< as the graph counts them
  double ByVote = 0.0;
  double Learnt = 0.0;
};

/// What the labelled meshes teach.
struct SourceLessons
{
  /// The power of the learnt probabilities by which the shares are multiplied; 0: nothing is learnt.
  double Exponent = 0.0;
  std::vector<HeldOutAccuracy> HeldOut; ///< per mesh that was held back
};

/// Learns from three labelled meshes or more, and multiplies `ofVertices`, what the vote says of the shapes
/// without labels, by what was learnt.
///
/// Of each of the meshes to hold out, which must be linked with other sources, the labels are held back, and
/// the vote of all others on it is taken as on any target. A forest (LabelForest) learns its labels from the
/// SurfaceFeatures and that vote. How far it is to be trusted is settled by forests that learn from all but one of them: the exponent is
/// that for which accuracy on the ones left out gains most, by the mean less half its standard error, of those by
/// which none of them loses half a percent or more. If there is none, or if the vote alone does badly on one of
/// them, nothing is changed. What `progress` stops is left unfinished.
SourceLessons LearnFromSources(const CollectionGraph& graph,
  const std::vector<int>& meshesToHoldOut, std::vector<LabelShares>& ofVertices,
  const Progress& progress);
}

#endif
