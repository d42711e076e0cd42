// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_GlobalCost_h
#define marrow_GlobalCost_h

#include "TerminalPaths.h"

#include <vector>

namespace marrow
{
/// What a correspondence of terminals costs, seen over the whole skeletons (ours; the correspondence
/// paper's cost looks at each junction by itself).
///
///   Σ W (|ΔAGD| + mean over the other matched terminals of how unlike the paths to them are)
///   + the weight of what is left unmatched · a constant
///   + the length of the branches that split the matched terminals as no branch of the other
///     skeleton does (they would have to be merged away)
///   + a penalty for handedness: (1 − correlation of the signed volumes of quadruples of matched
///     points) / 2; this alone tells left from right.
///
/// Paths are compared by length, by the profile of MSP along them and by how straight their middle
/// parts are. W is a terminal's share in the length and the surface of all terminal branches.
class GlobalCost
{
public:
  /// Per source terminal the target terminal, -1 for none.
  using Assignment = std::vector<int>;

  GlobalCost(const TerminalPaths& source, const TerminalPaths& target);

  /// Everything but handedness. In [0, about 1].
  double Intrinsic(const Assignment& targetOf) const;
  double Handedness(const Assignment& targetOf) const;
  double Total(const Assignment& targetOf) const
  {
    return this->Intrinsic(targetOf) + this->Handedness(targetOf);
  }
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
  std::vector<double> PathTable;
  std::vector<double> TerminalTable; ///< |ΔAGD|
};
}

#endif
