// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_GlobalCost_h
#define marrow_GlobalCost_h

#include "HintCost.h"
#include "MatchingWeights.h"
#include "TerminalPaths.h"

#include <vector>

namespace marrow
{
/// What a correspondence of terminals costs, seen over the whole skeletons (ours; the correspondence
/// paper's cost looks at each junction by itself).
///
///   Σ over matched pairs: W · (how unlike the two are), saturating
///   + W of what is left unmatched · a constant
///   + the branches that split the matched terminals as no branch of the other skeleton does, by
///     length (they would have to be merged away); little as long as they are within the junctions
///   + how far the terminals' branches are from lying alike in space after the best rotation
///   + a penalty for handedness: (1 − correlation of the signed volumes of quadruples of matched
///     points) / 2. It is small, and tells left from right where all else is equal.
///   + what the user's hints are not kept to (HintCost)
///
/// Two terminals are unlike by AGD, by how MSP grows inwards from the tip, and by the paths to all
/// other matched terminals: their length, the profile of MSP along them, how straight their middle
/// parts are, the angle between the branches at their ends, and whether those are twins (alike in
/// their own skeleton, as two legs are; what the paper's clusters are for). Nearly all of it stays as
/// it is when the pose changes. W is a terminal's share in the length and the surface of all terminal
/// branches.
class GlobalCost
{
public:
  /// Per source terminal the target terminal, -1 for none.
  using Assignment = std::vector<int>;

  GlobalCost(const TerminalPaths& source, const TerminalPaths& target,
    const MatchingWeights& weights, const std::vector<NodeHint>& hints = {});

  /// Everything but handedness. In [0, about 1], but for the hints.
  double Intrinsic(const Assignment& targetOf) const;
  double Handedness(const Assignment& targetOf) const;
  double Total(const Assignment& targetOf) const
  {
    return this->Intrinsic(targetOf) + this->Handedness(targetOf);
  }
  /// What is in it for the hints.
  double OfHints(const Assignment& targetOf) const { return this->Hints.Total(targetOf); }
  /// A first guess: terminals whose paths to all the others are alike.
  Assignment Guess() const;

private:
  double PathUnlike(int i, int k, int j, int l) const
  {
    return this
      ->PathTable[((i * this->Source.Size() + k) * this->Target.Size() + j) * this->Target.Size() +
        l];
  }
  double SplitCost(const Assignment& targetOf) const;
  double PoseCost(const Assignment& targetOf) const;

  const TerminalPaths& Source;
  const TerminalPaths& Target;
  MatchingWeights Weights;
  HintCost Hints;
  std::vector<double> PathTable;
  std::vector<double> TerminalTable; ///< |ΔAGD|
};
}

#endif
