// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelVotes_h
#define marrow_LabelVotes_h

#include "LabelShares.h"

#include <vector>

namespace marrow
{
/// One labelling of the faces of a mesh, by a person or a transfer.
struct Labelling
{
  std::vector<int> Labels;        ///< per face
  std::vector<double> Confidence; ///< per face, [0,1]; empty: 1
  double Weight = 1.0;            ///< how much it counts as a whole
};

/// The votes of labellings of one mesh, counted.
struct LabelVotes
{
  std::vector<int> Labels;          ///< all that occur, ascending: the columns
  LabelShares Shares;               ///< per face and label; rows sum to 1
  std::vector<double> Disagreement; ///< per face: the chance that two votes drawn by weight differ
};

/// Counts each labelling's vote on each face by its weight times its confidence there; where that is
/// nothing for all of them, by the weights alone.
LabelVotes CountVotes(const std::vector<Labelling>& labellings);

/// How often each labelling is right, and with that how much it ought to count, estimated from the labellings
/// alone: what they agree on most is taken for right, and who is right more often counts more, turn by turn
/// (expectation maximization, as in STAPLE, with one rate per labelling). `weightOfFace` is its area. Multiplies
/// the weights of the labellings by log(p (n - 1) / (1 - p)), p the rate and n the number of labels: the
/// weights by which independent voters are right most often. Returns the rates.
std::vector<double> WeighByTrust(
  const std::vector<double>& weightOfFace, std::vector<Labelling>& labellings);
}

#endif
