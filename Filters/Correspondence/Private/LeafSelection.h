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
  double PaperCost = 0.0;      ///< C_leaf (correspondence paper, equation 7)
  double GlobalCost = 0.0;     ///< see GlobalCost.h
  double SourceCoverage = 0.0; ///< length of the matched branches, of the whole skeleton's
  double TargetCoverage = 0.0;
};

/// The leaves with their costs, the best first: by GlobalCost if `global`, else by PaperCost; equal
/// ones stay in the order of the tree.
std::vector<RatedLeaf> RateLeaves(const FeatureGraph& source, const FeatureGraph& target,
  const std::vector<FeatureCorrespondence>& leaves, bool global);
}

#endif
