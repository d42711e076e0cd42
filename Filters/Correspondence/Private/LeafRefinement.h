// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LeafRefinement_h
#define marrow_LeafRefinement_h

#include "FeatureCorrespondence.h"
#include "GlobalCost.h"

#include <vector>

namespace marrow
{
/// The terminals that a leaf matches.
GlobalCost::Assignment TerminalAssignment(
  const TerminalPaths& source, const TerminalPaths& target, const FeatureCorrespondence& leaf);

/// Local search from each of `starts`: exchanges, adds and drops pairs of terminals until the global cost
/// falls no further, chirality left aside: it counts when the results are compared. Each result once.
std::vector<GlobalCost::Assignment> Descend(const GlobalCost& cost, const TerminalPaths& target,
  const std::vector<GlobalCost::Assignment>& starts);
}

#endif
