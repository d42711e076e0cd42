// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BeamSearch_h
#define marrow_BeamSearch_h

#include "GlobalCost.h"

#include <vector>

namespace marrow
{
/// Assignments of terminals that cost little and are unlike all of `known` and each other (ours), the cheapest first:
/// what neither the tree nor the local search came upon.
///
/// A beam search: the source's terminals are matched one after the other, the heaviest first, with every free
/// terminal of the target and with none; of all ways to match those so far, the cheapest go on. Two
/// assignments are unlike if they differ in a quarter of the source's terminals, by weight.
std::vector<GlobalCost::Assignment> FindOthers(const GlobalCost& cost, const TerminalPaths& source,
  const TerminalPaths& target, std::vector<GlobalCost::Assignment> known);
}

#endif
