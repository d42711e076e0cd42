// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LeafSelection_h
#define marrow_LeafSelection_h

#include "FeatureCorrespondence.h"
#include "HintCost.h"
#include "MatchingWeights.h"

#include <vector>

namespace marrow
{
/// A leaf with what decides about it.
struct RatedLeaf
{
  FeatureCorrespondence Match;
  bool Refined = false;   ///< not of the tree but found by a search
  double PaperCost = 0.0; ///< C_leaf (correspondence paper, equation 7)
  /// GlobalCost of the terminals, what the branches leave uncovered, how the surface is shared out
  double GlobalCost = 0.0;
  double CostOfHints = 0.0;    ///< what the hints are not kept to; before all else
  double SourceCoverage = 0.0; ///< length of the matched branches, of the whole skeleton's
  double TargetCoverage = 0.0;
};

/// The leaves with their costs, the best first; equal ones stay in the order of the tree. The cost is the
/// paper's, or if `global` the global one, in either case with that of the hints; where both skeletons have one component, the best leaves are
/// then refined by Descend, what is unlike them all is added by FindOthers, and by MatchBySplits the results
/// are leaves of their own. Of leaves that match
/// the same only the best is kept.
std::vector<RatedLeaf> RateLeaves(const FeatureGraph& source, const FeatureGraph& target,
  const std::vector<FeatureCorrespondence>& leaves, const MatchingWeights& weights, bool global,
  const std::vector<NodeHint>& hints = {});

/// The share of terminals that may be expected to be matched with the same part, in [0,1]: a logistic
/// function of GlobalCost, fitted to labelled meshes. The distance to the second best leaf tells
/// nothing, since that is mostly the same with left for right.
double Confidence(const RatedLeaf& leaf);
}

#endif
