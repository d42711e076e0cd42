// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerSearch.h"

#include "SkeletonMatching.h"

#include <utility>

namespace marrow
{
namespace
{
CorrespondenceIds::ChainOrder OrderOf(const SkeletonMatch::Side& side)
{
  return { side.BranchOrder, { side.BranchReversed.begin(), side.BranchReversed.end() } };
}
}

std::vector<Answer> FindAnswers(const Skeleton& source, const Skeleton& target,
  const std::vector<NodeHint>& hints, const Progress& progress)
{
  MatchingParameters parameters;
  parameters.Hints = hints;
  return FindAnswersBy(source, target, parameters, progress);
}

std::vector<Answer> FindAnswersBy(const Skeleton& source, const Skeleton& target,
  const MatchingParameters& parameters, const Progress& progress)
{
  std::vector<Answer> answers;
  SkeletonMatching matching;
  if (!MatchSkeletons(source, target, parameters, matching, progress))
  {
    return answers;
  }
  for (const SkeletonMatch& leaf : matching.Leaves)
  {
    if (answers.size() == MostAnswers)
    {
      break;
    }
    const CorrespondenceIds ids{ leaf.Source.NodeId, leaf.Target.NodeId, leaf.Source.BranchId,
      leaf.Target.BranchId, OrderOf(leaf.Source), OrderOf(leaf.Target) };
    Answer answer{ JoinChains(source, target, ids), leaf.GlobalCost, leaf.Confidence,
      leaf.CostOfHints };
    if (answer.IsWhole())
    {
      answer.Cost = 1.0; // To match nothing costs the skeletons little.
    }
    answers.push_back(std::move(answer));
  }
  return answers;
}

Answer Turned(const Answer& answer)
{
  Answer turned = answer;
  for (ChainPair& chain : turned.Match.Chains)
  {
    std::swap(chain.Source, chain.Target);
  }
  CorrespondenceIds& ids = turned.Match.Ids;
  std::swap(ids.SourceNodes, ids.TargetNodes);
  std::swap(ids.SourceBranches, ids.TargetBranches);
  std::swap(ids.SourceOrder, ids.TargetOrder);
  if (answer.Slices)
  {
    turned.Slices = answer.Slices->Inverse();
  }
  return turned;
}
}
