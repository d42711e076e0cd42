// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SplitConsensus_h
#define marrow_SplitConsensus_h

#include "FeatureCorrespondence.h"
#include "GlobalCost.h"

namespace marrow
{
/// The correspondence of nodes and branches that follows from one of terminals, for two skeletons of one
/// component each.
///
/// Every branch between matched terminals splits these in two sets. Branches of the two skeletons that
/// make the same split are the same part; several branches in a row that do (spurs between them) are
/// merged into a chain; branches that make a split unknown to the other skeleton are contracted, and
/// the junctions at their ends merged into a group. So the result has all matched branches that can be
/// had for these terminals, and the mergings are the fewest. Loops are opened at their longest branch
/// first; in the end the branches left out are matched where both of their ends are matched alike.
FeatureCorrespondence MatchBySplits(
  const TerminalPaths& source, const TerminalPaths& target, const GlobalCost::Assignment& targetOf);
}

#endif
