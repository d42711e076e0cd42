// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MatchedSkeletons_h
#define marrow_MatchedSkeletons_h

#include "Skeleton.h"

#include <vector>

namespace marrow
{
/// What a correspondence of two skeletons says, as the arrays of the data contract hold it: equal
/// ids are matched, -1 is unmatched.
struct CorrespondenceIds
{
  std::vector<int> SourceNodes;
  std::vector<int> TargetNodes;
  std::vector<int> SourceBranches;
  std::vector<int> TargetBranches;

  /// The place of a branch in its chain and whether it runs against it, on both skeletons; empty if
  /// the correspondence does not say so.
  struct ChainOrder
  {
    std::vector<int> Order;
    std::vector<int> Reversed;

    bool IsKnown() const { return !this->Order.empty() && !this->Reversed.empty(); }
  };
  ChainOrder SourceOrder;
  ChainOrder TargetOrder;
};

/// Two matched paths, run from matched end to matched end. A path is one branch, or several in a row
/// where the correspondence skipped a junction (branch merging).
struct ChainPair
{
  Branch Source;
  Branch Target;
};

/// The matched part of two skeletons.
struct MatchedSkeletons
{
  std::vector<ChainPair> Chains;
  CorrespondenceIds Ids;

  bool IsEmpty() const { return this->Chains.empty(); }
};

/// Joins the branches of equal id to chains and runs both chains of a pair the same way: as the
/// correspondence says, else by the ids of their ends and, where these say nothing, by the AGD of
/// their ends.
MatchedSkeletons JoinChains(
  const Skeleton& source, const Skeleton& target, const CorrespondenceIds& ids);

/// The arc length at which a chain's `ratio` in [0,1] sits, as node index and fraction of the way to
/// the next node.
struct ChainPosition
{
  int Index = 0;
  double Fraction = 0.0;
};
ChainPosition LocateOnChain(const Branch& chain, double ratio);

Eigen::Vector3d PointOnChain(const Skeleton& skeleton, const Branch& chain, double ratio);
/// Unit direction of the chain around `ratio`: the chord that reaches `reach` to both sides.
Eigen::Vector3d TangentOfChain(
  const Skeleton& skeleton, const Branch& chain, double ratio, double reach);
/// A value given per skeleton node, interpolated linearly.
template <typename Value>
double InterpolateOnChain(const Branch& chain, double ratio, Value&& valueOfNode)
{
  const ChainPosition at = LocateOnChain(chain, ratio);
  const int next = at.Index + 1 < static_cast<int>(chain.Nodes.size()) ? at.Index + 1 : at.Index;
  return (1.0 - at.Fraction) * valueOfNode(chain.Nodes[at.Index]) +
    at.Fraction * valueOfNode(chain.Nodes[next]);
}
}

#endif
