// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnswerSearch_h
#define marrow_AnswerSearch_h

#include "AnswerChoice.h"
#include "Hints.h"
#include "Progress.h"
#include "Skeleton.h"

#include <vector>

namespace marrow
{
struct MatchingParameters;

/// The answers to how two skeletons match, the cheapest first, at most MostAnswers; at least one, which
/// may match nothing. Those that keep to the hints come first. None if `progress` asked to stop.
std::vector<Answer> FindAnswers(const Skeleton& source, const Skeleton& target,
  const std::vector<NodeHint>& hints, const Progress& progress);
/// The same, but not by the defaults of the matching.
std::vector<Answer> FindAnswersBy(const Skeleton& source, const Skeleton& target,
  const MatchingParameters& parameters, const Progress& progress);

/// The same answer with the target for the source.
Answer Turned(const Answer& answer);
}

#endif
