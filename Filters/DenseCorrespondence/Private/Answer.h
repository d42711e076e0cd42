// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Answer_h
#define marrow_Answer_h

#include "MatchedSkeletons.h"
#include "SliceAlignment.h"

#include <cstddef>
#include <optional>

namespace marrow
{
/// One of the answers to what corresponds to what.
struct Answer
{
  MatchedSkeletons Match;
  /// By the skeletons or slices alone, some 0 to 1. Where nothing is matched: beside other answers hardly more than the
  /// first's (see AddWhole), else 1.
  double Cost = 1.0;
  double Confidence = 1.0;  ///< [0,1], likewise
  double CostOfHints = 0.0; ///< what it does not keep to of the user's hints, by the skeletons
  bool IsGiven = false;     ///< by the user, with its confidence: not found
  /// Of two surfaces of revolution, where the skeletons are left aside: nothing of them is matched.
  std::optional<SliceAlignment> Slices = std::nullopt;

  /// Nothing is matched: the meshes are aligned as wholes.
  bool IsWhole() const { return this->Match.IsEmpty() && !this->Slices; }
};

/// More of skeletons and slices are not tried: the right one is hardly ever farther down, and each takes time.
inline constexpr std::size_t MostAnswers = 14;
}

#endif
