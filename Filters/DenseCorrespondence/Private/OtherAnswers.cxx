// SPDX-License-Identifier: BSD-3-Clause
#include "OtherAnswers.h"

#include <algorithm>
#include <utility>

namespace marrow
{
namespace
{
MatchedSkeletons NothingMatched(const Skeleton& source, const Skeleton& target)
{
  CorrespondenceIds ids;
  ids.SourceNodes.assign(source.NumberOfNodes(), -1);
  ids.TargetNodes.assign(target.NumberOfNodes(), -1);
  ids.SourceBranches.assign(source.Branches.size(), -1);
  ids.TargetBranches.assign(target.Branches.size(), -1);
  return JoinChains(source, target, ids);
}

Answer AnswerBySlices(const AnalyzedMesh& source, const AnalyzedMesh& target, bool isTurned)
{
  SliceAlignment alignment(*source.Slices, *target.Slices, isTurned);
  Answer answer;
  answer.Match = NothingMatched(source.Skeleton, target.Skeleton);
  answer.Cost = alignment.GetCost();
  answer.Confidence = 1.0 - alignment.GetCost();
  answer.Slices = std::move(alignment);
  return answer;
}
}

void PreferSlices(
  const AnalyzedMesh& source, const AnalyzedMesh& target, std::vector<Answer>& answers)
{
  if (!source.Slices || !target.Slices)
  {
    return;
  }
  std::vector<Answer> all{ AnswerBySlices(source, target, false),
    AnswerBySlices(source, target, true) };
  if (all[1].Cost < all[0].Cost)
  {
    std::swap(all[0], all[1]);
  }
  constexpr double mostCost = 0.5; // of 1 at most, where nothing agrees
  if (all[0].Cost > mostCost)
  {
    return;
  }
  for (Answer& answer : answers)
  {
    if (all.size() < MostAnswers)
    {
      answer.Cost = 1.0;
      all.push_back(std::move(answer));
    }
  }
  answers = std::move(all);
}

void AddWhole(const AnalyzedMesh& source, const AnalyzedMesh& target, std::vector<Answer>& answers)
{
  if (std::any_of(answers.begin(), answers.end(),
        [](const Answer& answer) { return answer.IsWhole() || answer.Slices; }))
  {
    return;
  }
  Answer whole;
  whole.Match = NothingMatched(source.Skeleton, target.Skeleton);
  /// What is nearly the same shape fits as a whole too, and is better said by skeletons. From 0.05 to 0.1 the accuracy
  /// on real meshes is the same.
  constexpr double clearlyBetter = 0.1;
  whole.Cost = answers.front().Cost + clearlyBetter;
  whole.CostOfHints = answers.front().CostOfHints;
  whole.Confidence = 0.0;
  answers.push_back(std::move(whole));
}
}
