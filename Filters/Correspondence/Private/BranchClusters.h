// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BranchClusters_h
#define marrow_BranchClusters_h

#include "FeatureGraph.h"

#include <vector>

namespace marrow
{
/// Groups the branches of a junction whose MSP descriptors are alike (correspondence paper, 4.2.2):
/// per dart the number of its cluster, from 0, or -1 if it is like no other.
///
/// Two branches are alike when the Euclidean distance of their descriptors is at most `distance`.
/// The paper makes pairs, and where three or more are alike one child of the tree for every pair;
/// here they stay together in one cluster (complete linkage, the closest first), which allows the
/// same assignments without repeating them.
std::vector<int> ClusterBranches(
  const FeatureGraph& graph, const std::vector<int>& darts, double distance);

/// How many clusters ClusterBranches made.
int NumberOfClusters(const std::vector<int>& clusters);
}

#endif
