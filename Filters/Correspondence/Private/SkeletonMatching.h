// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonMatching_h
#define marrow_SkeletonMatching_h

#include "CorrespondenceTree.h"
#include "ElectorsVoting.h"
#include "LeafSelection.h"

#include <vector>

namespace marrow
{
enum class Matcher
{
  CorrespondenceTree,
  ElectorsVoting
};

struct MatchingParameters
{
  Matcher Method = Matcher::CorrespondenceTree;
  VotingParameters Voting;
  TreeParameters Tree;
  int DescriptorPieces = 8;
  bool GlobalSelection = true;
  MatchingWeights Weights;
  std::vector<NodeHint> Hints; ///< nodes of the skeletons as given
};

/// A leaf in the numbers of the skeletons. The vectors of one side: per node and per branch.
struct SkeletonMatch
{
  struct Side
  {
    std::vector<int> NodeId;      ///< -1 if unmatched
    std::vector<int> BranchId;    ///< -1 if unmatched
    std::vector<int> BranchOrder; ///< place in the chain, -1 if unmatched
    std::vector<unsigned char> BranchReversed;
  };
  Side Source;
  Side Target;
  int JunctionPairs = 0;
  int TerminalPairs = 0;
  int BranchPairs = 0;
  int Merges = 0;
  bool Refined = false; ///< not a leaf of the tree but found by going on from one
  double PaperCost = 0.0;
  double GlobalCost = 0.0;
  double CostOfHints = 0.0; ///< what the hints are not kept to
  double Confidence = 0.0;
  double SourceCoverage = 0.0;
  double TargetCoverage = 0.0;

  /// What the leaves are sorted by with global selection.
  double RankedCost() const { return this->GlobalCost + this->CostOfHints; }
};

struct SkeletonMatching
{
  std::vector<SkeletonMatch> Leaves; ///< the best first; at least one, which may match nothing
  TreeStatistics Statistics;
};

/// Matches two skeletons with at least one branch each. Electors voting has one leaf. False if `progress`
/// asked to stop.
///
/// If one skeleton has more loops than the other, the correspondence tree with global selection also
/// tries to open the loops that are too many (OpenedSkeleton): the leaves are those of the opening
/// that costs least, if that is clearly less than without.
bool MatchSkeletons(const Skeleton& source, const Skeleton& target,
  const MatchingParameters& parameters, SkeletonMatching& result, const Progress& progress = {});
}

#endif
