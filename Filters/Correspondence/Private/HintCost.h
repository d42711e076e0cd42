// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_HintCost_h
#define marrow_HintCost_h

#include "Hints.h"
#include "TerminalPaths.h"

#include <utility>
#include <vector>

namespace marrow
{
/// What a correspondence of terminals costs for not keeping to hints (ours).
///
/// Two nodes are of the same part if the terminals on whose branches they lie are matched with each other; else
/// the less, the less they are as far from every matched terminal as each other, over the mean distance
/// on their skeletons. Forbidden are matches of the terminals on whose branches two
/// nodes lie; about nodes on other branches terminals say nothing.
class HintCost
{
public:
  /// More than all other costs of an answer together, which are about 1 at most.
  static constexpr double Weight = 10.0;

  /// The nodes are those of the skeletons that the graphs were made of.
  HintCost(
    const TerminalPaths& source, const TerminalPaths& target, const std::vector<NodeHint>& hints);

  /// Of matching one terminal with another.
  double OfPair(int source, int target) const
  {
    return this->PairCosts[source * this->Targets + target];
  }
  /// Of an assignment: per source terminal the target terminal, -1 for none.
  double Total(const std::vector<int>& targetOf) const;

private:
  /// That two nodes are of the same part.
  struct Pair
  {
    /// On whose branches they lie; -1: on no terminal's.
    int SourceTerminal = -1;
    int TargetTerminal = -1;
    std::vector<double>
      Costs; ///< per pair of terminals, as PairCosts; empty: there is no way to any
  };
  double Of(const Pair& pair, const std::vector<int>& targetOf) const;

  int Targets = 0;
  std::vector<double> PairCosts;
  std::vector<Pair> Pairs;
  std::vector<std::pair<int, int>> ForbiddenBranches;
};
}

#endif
