// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_RejectedAnswers_h
#define marrow_RejectedAnswers_h

#include "CollectionGraph.h"

#include <vector>

namespace marrow
{
/// How a shape would be labelled by an answer that was not taken.
struct RejectedAnswer
{
  std::vector<int> Labels; ///< per triangle; as coarse as the answers were tried out
  double Against = 0.0;    ///< what speaks against it: Evidence's sum
  double Difference = 0.0; ///< from the labels that the shape got, as a share of its area
};

/// Of the answers of a shape and the source `source`, which tells it something, at most `most` that were not
/// taken and would label it visibly otherwise than `labels`, than the one taken and than each other. Those
/// first that come nearest to being taken, by what speaks against them and their difference.
std::vector<RejectedAnswer> FindRejectedAnswers(const CollectionGraph& graph, int shape, int source,
  const std::vector<int>& labels, std::size_t most);
}

#endif
