// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelCut_h
#define marrow_LabelCut_h

#include "Progress.h"

#include <utility>
#include <vector>

namespace marrow
{
/// A labelling problem on a graph: what each site pays for each label that it may take, and what
/// neighbours pay when their labels differ.
struct LabelProblem
{
  struct Edge
  {
    int A;
    int B;
    double Weight;
  };
  /// Per site (label, cost), at least one.
  std::vector<std::vector<std::pair<int, double>>> Costs;
  std::vector<Edge> Edges;
  int NumberOfLabels = 0;
};

/// Alpha expansion (Boykov, Veksler, Zabih 2001): starts from the cheapest label of every site and
/// lets one label after the other grow by a minimum cut until none can. A site only ever takes a
/// label of its own list, so what is certain (one label) costs nothing.
std::vector<int> SolveLabels(const LabelProblem& problem, const Progress& progress);
}

#endif
