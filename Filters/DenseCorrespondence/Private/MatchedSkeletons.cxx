// SPDX-License-Identifier: BSD-3-Clause
#include "MatchedSkeletons.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace marrow
{
namespace
{
Branch Reversed(const Branch& branch)
{
  Branch result;
  for (std::size_t i = branch.Nodes.size(); i-- > 0;)
  {
    result.Nodes.push_back(branch.Nodes[i]);
    result.ArcLength.push_back(branch.Length() - branch.ArcLength[i]);
  }
  return result;
}

void Append(Branch& chain, const Branch& next)
{
  const double offset = chain.Length();
  for (std::size_t i = 1; i < next.Nodes.size(); ++i)
  {
    chain.Nodes.push_back(next.Nodes[i]);
    chain.ArcLength.push_back(offset + next.ArcLength[i]);
  }
}

/// Joins branches end to end, starting at a free end. Branches that do not fit (a correspondence
/// that gives one id to branches side by side) are left out; the longest chain is kept.
Branch JoinBranches(const Skeleton& skeleton, const std::vector<int>& members)
{
  std::map<int, int> uses;
  for (int b : members)
  {
    ++uses[skeleton.Branches[b].Front()];
    ++uses[skeleton.Branches[b].Back()];
  }
  Branch best;
  std::vector<bool> used(members.size(), false);
  for (int pass = 0; pass < 2; ++pass)
  {
    // First from free ends; what is left then can only be a cycle, which may start anywhere.
    for (std::size_t first = 0; first < members.size(); ++first)
    {
      const Branch& start = skeleton.Branches[members[first]];
      const bool freeFront = uses[start.Front()] == 1;
      const bool freeBack = uses[start.Back()] == 1;
      if (used[first] || (pass == 0 && !freeFront && !freeBack))
      {
        continue;
      }
      used[first] = true;
      Branch chain = freeFront || !freeBack ? start : Reversed(start);
      for (bool grown = true; grown;)
      {
        grown = false;
        for (std::size_t next = 0; next < members.size() && !grown; ++next)
        {
          const Branch& candidate = skeleton.Branches[members[next]];
          if (used[next] || (candidate.Front() != chain.Back() && candidate.Back() != chain.Back()))
          {
            continue;
          }
          Append(chain, candidate.Front() == chain.Back() ? candidate : Reversed(candidate));
          used[next] = true;
          grown = true;
        }
      }
      if (best.Nodes.empty() || chain.Length() > best.Length())
      {
        best = std::move(chain);
      }
    }
  }
  return best;
}

/// Joins branches as the correspondence orders them; empty if they do not meet end to end.
Branch JoinInOrder(
  const Skeleton& skeleton, std::vector<int> members, const CorrespondenceIds::ChainOrder& order)
{
  std::sort(
    members.begin(), members.end(), [&](int a, int b) { return order.Order[a] < order.Order[b]; });
  Branch chain;
  for (int b : members)
  {
    const Branch& branch = skeleton.Branches[b];
    const Branch next = order.Reversed[b] ? Reversed(branch) : branch;
    if (chain.Nodes.empty())
    {
      chain = next;
    }
    else if (chain.Back() == next.Front())
    {
      Append(chain, next);
    }
    else
    {
      return {};
    }
  }
  return chain;
}

std::map<int, std::vector<int>> MembersOfIds(const std::vector<int>& ids)
{
  std::map<int, std::vector<int>> members;
  for (std::size_t b = 0; b < ids.size(); ++b)
  {
    if (ids[b] >= 0)
    {
      members[ids[b]].push_back(static_cast<int>(b));
    }
  }
  return members;
}

bool SameId(int a, int b)
{
  return a >= 0 && a == b;
}
}

MatchedSkeletons JoinChains(
  const Skeleton& source, const Skeleton& target, const CorrespondenceIds& ids)
{
  MatchedSkeletons match;
  match.Ids = ids;
  const auto sourceMembers = MembersOfIds(ids.SourceBranches);
  const auto targetMembers = MembersOfIds(ids.TargetBranches);
  for (const auto& [id, members] : sourceMembers)
  {
    const auto partner = targetMembers.find(id);
    if (partner == targetMembers.end())
    {
      continue;
    }
    if (ids.SourceOrder.IsKnown() && ids.TargetOrder.IsKnown())
    {
      ChainPair ordered{ JoinInOrder(source, members, ids.SourceOrder),
        JoinInOrder(target, partner->second, ids.TargetOrder) };
      if (!ordered.Source.Nodes.empty() && !ordered.Target.Nodes.empty() &&
        ordered.Source.Length() > 0.0 && ordered.Target.Length() > 0.0)
      {
        match.Chains.push_back(std::move(ordered));
        continue;
      }
    }
    ChainPair pair{ JoinBranches(source, members), JoinBranches(target, partner->second) };
    if (pair.Source.Length() <= 0.0 || pair.Target.Length() <= 0.0)
    {
      continue;
    }
    const int sourceFront = ids.SourceNodes[pair.Source.Front()];
    const int sourceBack = ids.SourceNodes[pair.Source.Back()];
    const int targetFront = ids.TargetNodes[pair.Target.Front()];
    const int targetBack = ids.TargetNodes[pair.Target.Back()];
    const int forward = SameId(sourceFront, targetFront) + SameId(sourceBack, targetBack);
    const int backward = SameId(sourceFront, targetBack) + SameId(sourceBack, targetFront);
    const auto difference = [&](int s, int t)
    { return std::abs(source.Graph[s].AGD - target.Graph[t].AGD); };
    const double forwardCost = difference(pair.Source.Front(), pair.Target.Front()) +
      difference(pair.Source.Back(), pair.Target.Back());
    const double backwardCost = difference(pair.Source.Front(), pair.Target.Back()) +
      difference(pair.Source.Back(), pair.Target.Front());
    if (backward > forward || (backward == forward && backwardCost < forwardCost))
    {
      pair.Target = Reversed(pair.Target);
    }
    match.Chains.push_back(std::move(pair));
  }
  return match;
}

ChainPosition LocateOnChain(const Branch& chain, double ratio)
{
  const double arc = std::clamp(ratio, 0.0, 1.0) * chain.Length();
  const auto above = std::upper_bound(chain.ArcLength.begin(), chain.ArcLength.end(), arc);
  const int last = static_cast<int>(chain.Nodes.size()) - 1;
  const int index =
    std::clamp(static_cast<int>(above - chain.ArcLength.begin()) - 1, 0, std::max(last - 1, 0));
  if (index >= last)
  {
    return { last, 0.0 };
  }
  const double step = chain.ArcLength[index + 1] - chain.ArcLength[index];
  return { index, step > 0.0 ? std::clamp((arc - chain.ArcLength[index]) / step, 0.0, 1.0) : 0.0 };
}

Eigen::Vector3d PointOnChain(const Skeleton& skeleton, const Branch& chain, double ratio)
{
  const ChainPosition at = LocateOnChain(chain, ratio);
  const int next = std::min(at.Index + 1, static_cast<int>(chain.Nodes.size()) - 1);
  return (1.0 - at.Fraction) * skeleton.Graph[chain.Nodes[at.Index]].Position +
    at.Fraction * skeleton.Graph[chain.Nodes[next]].Position;
}

Eigen::Vector3d TangentOfChain(
  const Skeleton& skeleton, const Branch& chain, double ratio, double reach)
{
  const double step = chain.Length() > 0.0 ? reach / chain.Length() : 0.0;
  const Eigen::Vector3d chord =
    PointOnChain(skeleton, chain, ratio + step) - PointOnChain(skeleton, chain, ratio - step);
  const double length = chord.norm();
  if (length > 0.0)
  {
    return chord / length;
  }
  const Eigen::Vector3d whole =
    PointOnChain(skeleton, chain, 1.0) - PointOnChain(skeleton, chain, 0.0);
  return whole.norm() > 0.0 ? Eigen::Vector3d(whole.normalized()) : Eigen::Vector3d::UnitX();
}
}
