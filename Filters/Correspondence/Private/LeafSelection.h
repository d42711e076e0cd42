// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LeafSelection_h
#define marrow_LeafSelection_h

#include "FeatureCorrespondence.h"

#include <vector>

namespace marrow
{
/// A leaf with what decides about it.
struct RatedLeaf
{
  FeatureCorrespondence Match;
  bool Refined = false;        ///< not of the tree but found by going on from its leaves
  double PaperCost = 0.0;      ///< C_leaf (correspondence paper, equation 7)
  double Cost = 0.0;           ///< what the leaves are sorted by
  double SourceCoverage = 0.0; ///< length of the matched branches, of the whole skeleton's
  double TargetCoverage = 0.0;
};

/// The leaves with their costs, the best first; equal ones stay in the order of the tree.
///
/// If `global`, the cost is GlobalCost of the matched terminals and what the branches leave
/// uncovered; and where both skeletons have one component, the best leaves are refined by Descend and
/// MatchBySplits, and the results are leaves of their own. Else the cost is the paper's.
std::vector<RatedLeaf> RateLeaves(const FeatureGraph& source, const FeatureGraph& target,
  const std::vector<FeatureCorrespondence>& leaves, bool global);

/// How sure the sorted leaves are that the first one is right, in [0,1].
double Confidence(const std::vector<RatedLeaf>& leaves);
}

#endif
