// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LoopOpening_h
#define marrow_LoopOpening_h

#include "Skeleton.h"

#include <vector>

namespace marrow
{
/// A skeleton some of whose loops were opened, with the way back to the one that was given.
///
/// Where two limbs of a body touch and the surface has grown together, the skeleton has a loop that
/// the bodies it is to be matched with do not have. The loop is opened where the one limb ends on the
/// other: the branch is taken off the junction, so that it has a tip again, and what the junction
/// joined besides is one branch again.
struct OpenedSkeleton
{
  /// A branch of the given skeleton as part of one of the opened one.
  struct Part
  {
    int Branch = -1;
    bool Reversed = false;
  };
  Skeleton Opened;                      ///< with the nodes of the given one, in the same order
  std::vector<int> GivenNode;           ///< per node: a new tip stands for the junction it was at
  std::vector<std::vector<Part>> Parts; ///< per branch, in its direction
  int GivenBranches = 0;                ///< number of branches of the given skeleton

  /// Nothing opened yet.
  explicit OpenedSkeleton(const Skeleton& given);

  /// The parts of a branch, in its direction or against it.
  std::vector<Part> PartsAlong(int branch, bool against) const;

  /// One end of a branch of the opened skeleton.
  struct BranchEnd
  {
    int Branch = -1;
    bool AtBack = false;
  };
  /// The ends of branches that are on a loop, at junctions of three branches: these are junctions no
  /// more when one is taken off, so that the tip can stand for them.
  std::vector<BranchEnd> OpenableEnds() const;
  /// With this end taken off its junction. The new tip is where the branch leaves the junction's ball.
  OpenedSkeleton OpenedAt(const BranchEnd& end) const;

private:
  /// The nodes of the branch from this end on that go with it, the new tip last; empty if too little of
  /// the branch would be left.
  std::vector<int> NodesToDrop(const BranchEnd& end) const;
  bool IsOnLoop(int branch, const std::vector<std::vector<int>>& branchesOfNodes) const;
};
}

#endif
