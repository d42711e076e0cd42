// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FeatureCorrespondence_h
#define marrow_FeatureCorrespondence_h

#include "FeatureGraph.h"

#include <vector>

namespace marrow
{
/// Two feature nodes, or two groups of merged junctions, that are one and the same part.
struct MatchedNodes
{
  FeatureGroup Source;
  FeatureGroup Target;
  double Cost = 0.0; ///< C_junc of junctions; of terminals, which have none, 0
};

/// Two branches, or chains of merged branches, that are one and the same part. Both run from the
/// pair First to the pair Last.
struct MatchedBranches
{
  std::vector<int> Source; ///< darts of the source's FeatureGraph, in order
  std::vector<int> Target;
  int First = -1; ///< index of the matched nodes where both begin
  int Last = -1;  ///< where both end; -1 while the tree has not come there
};

/// One leaf of the correspondence tree.
struct FeatureCorrespondence
{
  std::vector<MatchedNodes> Nodes;
  std::vector<MatchedBranches> Branches;
  std::vector<double> JunctionCosts; ///< one C_junc per matched junction pair
  std::vector<double> BranchCosts;   ///< one C_branch per junction pair whose branches were matched
  int Merges = 0;                    ///< junction and branch mergings
};

/// What the correspondence paper's Table 3 reports of a tree.
struct TreeStatistics
{
  int TreeNodes = 0;
  int Height = 0;
  int CorePairs = 0;
  int Merges = 0;
  int Clusters = 0;
  int Leaves = 0;
};
}

#endif
