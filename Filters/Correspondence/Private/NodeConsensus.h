// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_NodeConsensus_h
#define marrow_NodeConsensus_h

#include "FeatureCorrespondence.h"
#include "FeaturePaths.h"

#include <utility>
#include <vector>

namespace marrow
{
/// The correspondence of nodes and branches that follows from pairs of features, one to one (numbers of
/// the two FeaturePaths).
///
/// Two matched pairs that no other lies between, on neither skeleton, are joined by a pair of branches,
/// chains if unmatched junctions lie on the way. Where chains would share a branch, the one of the most
/// alike lengths has it. Last, branches left over are matched if both ends are, which closes loops.
FeatureCorrespondence MatchByNodes(const FeaturePaths& source, const FeaturePaths& target,
  const std::vector<std::pair<int, int>>& pairs);
}

#endif
