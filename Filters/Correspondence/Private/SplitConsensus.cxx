// SPDX-License-Identifier: BSD-3-Clause
#include "SplitConsensus.h"

#include "BranchCosts.h"
#include "BranchLikeness.h"
#include "JunctionCost.h"
#include "LoopDirection.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace marrow
{
namespace
{
using Mask = TerminalPaths::Mask;

/// One skeleton, seen by the matched terminals; bit k is the k-th matched pair.
class SplitTree
{
public:
  SplitTree(const TerminalPaths& paths, const std::vector<int>& matched)
    : Graph(paths.Graph())
    , Group(paths.Graph().NumberOfFeatures())
  {
    std::iota(this->Group.begin(), this->Group.end(), 0);
    for (int dart = 0; dart < 2 * this->Graph.NumberOfBranches(); ++dart)
    {
      const Mask beyond = paths.Beyond(dart);
      Mask mask = 0;
      for (std::size_t k = 0; k < matched.size(); ++k)
      {
        if ((beyond >> matched[k] & 1) != 0)
        {
          mask |= Mask(1) << k;
        }
      }
      // Away from the first pair, and between matched terminals only.
      if ((mask & 1) == 0 && mask != 0)
      {
        this->Chains[mask].push_back(dart);
      }
    }
    for (auto& entry : this->Chains)
    {
      this->Sort(entry.second);
    }
  }

  const std::vector<int>* Chain(Mask mask) const
  {
    const auto found = this->Chains.find(mask);
    return found == this->Chains.end() ? nullptr : &found->second;
  }
  /// Contracts the chains that `other` does not know.
  void Contract(const SplitTree& other)
  {
    for (const auto& [mask, darts] : this->Chains)
    {
      if (!other.Chain(mask))
      {
        for (int dart : darts)
        {
          this->Join(this->Graph.Origin(dart), this->Graph.Head(dart));
          this->Inside.push_back(dart / 2);
        }
      }
    }
  }
  FeatureGroup GroupOf(int feature) const
  {
    FeatureGroup group;
    for (int f = 0; f < this->Graph.NumberOfFeatures(); ++f)
    {
      if (this->Group[f] == this->Group[feature])
      {
        group.Features.push_back(f);
      }
    }
    for (int branch : this->Inside)
    {
      if (this->Group[this->Graph.Origin(2 * branch)] == this->Group[feature])
      {
        group.Inside.push_back(branch);
      }
    }
    std::sort(group.Inside.begin(), group.Inside.end());
    return group;
  }
  std::map<Mask, std::vector<int>> Chains;

private:
  /// Puts the darts of a chain in a row.
  void Sort(std::vector<int>& darts) const
  {
    std::vector<int> row;
    std::set<int> heads;
    for (int dart : darts)
    {
      heads.insert(this->Graph.Head(dart));
    }
    int next = -1;
    for (int dart : darts)
    {
      if (heads.count(this->Graph.Origin(dart)) == 0)
      {
        next = dart;
      }
    }
    while (next >= 0)
    {
      row.push_back(next);
      const int head = this->Graph.Head(next);
      const auto found = std::find_if(
        darts.begin(), darts.end(), [&](int dart) { return this->Graph.Origin(dart) == head; });
      next = found == darts.end() ? -1 : *found;
    }
    darts = row;
  }
  void Join(int a, int b)
  {
    const int from = this->Group[a];
    const int to = this->Group[b];
    std::replace(this->Group.begin(), this->Group.end(), from, to);
  }

  const FeatureGraph& Graph;
  std::vector<int> Group;
  std::vector<int> Inside;
};

/// Turns the matched branches so that all of them lead away from the most central matched nodes.
void LeadAway(FeatureCorrespondence& match, const FeatureGraph& source, const FeatureGraph& target)
{
  std::vector<std::vector<int>> branchesOf(match.Nodes.size());
  for (std::size_t b = 0; b < match.Branches.size(); ++b)
  {
    branchesOf[match.Branches[b].First].push_back(static_cast<int>(b));
    branchesOf[match.Branches[b].Last].push_back(static_cast<int>(b));
  }
  const auto centricity = [&](std::size_t i)
  { return source.AGD(match.Nodes[i].Source) + target.AGD(match.Nodes[i].Target); };
  std::size_t root = 0;
  for (std::size_t i = 1; i < match.Nodes.size(); ++i)
  {
    root = centricity(i) < centricity(root) ? i : root;
  }
  std::vector<bool> done(match.Branches.size(), false);
  std::vector<int> open{ static_cast<int>(root) };
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    for (int b : branchesOf[open[i]])
    {
      if (done[b])
      {
        continue;
      }
      done[b] = true;
      MatchedBranches& branches = match.Branches[b];
      if (branches.First != open[i])
      {
        std::swap(branches.First, branches.Last);
        for (std::vector<int>* path : { &branches.Source, &branches.Target })
        {
          std::reverse(path->begin(), path->end());
          for (int& dart : *path)
          {
            dart ^= 1;
          }
        }
      }
      open.push_back(branches.Last);
    }
  }
}
/// Matches the branches outside the forests that join the same matched nodes, the most alike first.
void CloseLoops(
  FeatureCorrespondence& match, const FeatureGraph& source, const FeatureGraph& target)
{
  struct Loop
  {
    int Source; ///< darts
    int Target;
    int First;
    int Last;
    double Unlikeness;
  };
  const auto nodesOf = [&](const FeatureGraph& graph, FeatureGroup MatchedNodes::*side)
  {
    std::vector<int> result(graph.NumberOfFeatures(), -1);
    for (std::size_t i = 0; i < match.Nodes.size(); ++i)
    {
      for (int feature : (match.Nodes[i].*side).Features)
      {
        result[feature] = static_cast<int>(i);
      }
    }
    return result;
  };
  const std::vector<int> sourceNodes = nodesOf(source, &MatchedNodes::Source);
  const std::vector<int> targetNodes = nodesOf(target, &MatchedNodes::Target);
  std::vector<Loop> loops;
  for (int b = 0; b < source.NumberOfBranches(); ++b)
  {
    const int first = sourceNodes[source.Origin(2 * b)];
    const int last = sourceNodes[source.Head(2 * b)];
    if (source.IsInForest(b) || first < 0 || last < 0)
    {
      continue;
    }
    for (int dart = 0; dart < 2 * target.NumberOfBranches(); ++dart)
    {
      // Of a loop at one pair of nodes the direction is found later.
      if (!target.IsInForest(dart / 2) && targetNodes[target.Origin(dart)] == first &&
        targetNodes[target.Head(dart)] == last && (first != last || dart % 2 == 0))
      {
        loops.push_back(
          { 2 * b, dart, first, last, PathUnlikeness(source, { 2 * b }, target, { dart }) });
      }
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
    [](const Loop& a, const Loop& b) { return a.Unlikeness < b.Unlikeness; });
  std::set<int> sourceUsed;
  std::set<int> targetUsed;
  for (const Loop& loop : loops)
  {
    if (sourceUsed.count(loop.Source / 2) == 0 && targetUsed.count(loop.Target / 2) == 0)
    {
      sourceUsed.insert(loop.Source / 2);
      targetUsed.insert(loop.Target / 2);
      const int dart = loop.First == loop.Last
        ? DirectLoop(source, target, match, loop.First, loop.Source, loop.Target)
        : loop.Target;
      match.Branches.push_back({ { loop.Source }, { dart }, loop.First, loop.Last });
    }
  }
}
}

FeatureCorrespondence MatchBySplits(
  const TerminalPaths& source, const TerminalPaths& target, const GlobalCost::Assignment& targetOf)
{
  std::vector<int> sourceTerminals;
  std::vector<int> targetTerminals;
  for (int i = 0; i < source.Size(); ++i)
  {
    if (targetOf[i] >= 0)
    {
      sourceTerminals.push_back(i);
      targetTerminals.push_back(targetOf[i]);
    }
  }
  FeatureCorrespondence match;
  if (sourceTerminals.size() < 2)
  {
    return match;
  }
  SplitTree sourceTree(source, sourceTerminals);
  SplitTree targetTree(target, targetTerminals);
  sourceTree.Contract(targetTree);
  targetTree.Contract(sourceTree);

  const FeatureGraph& s = source.Graph();
  const FeatureGraph& t = target.Graph();
  const auto addNodes = [&](int sourceFeature, int targetFeature)
  {
    MatchedNodes nodes;
    nodes.Source = sourceTree.GroupOf(sourceFeature);
    nodes.Target = targetTree.GroupOf(targetFeature);
    for (std::size_t i = 0; i < match.Nodes.size(); ++i)
    {
      if (match.Nodes[i].Source == nodes.Source)
      {
        return static_cast<int>(i);
      }
    }
    if (!s.GetFeatures()[sourceFeature].IsTerminal())
    {
      nodes.Cost = JunctionCost(s, nodes.Source, t, nodes.Target);
      match.JunctionCosts.push_back(nodes.Cost);
    }
    match.Merges +=
      static_cast<int>(nodes.Source.Features.size() + nodes.Target.Features.size()) - 2;
    match.Nodes.push_back(nodes);
    return static_cast<int>(match.Nodes.size()) - 1;
  };
  for (const auto& [mask, sourceChain] : sourceTree.Chains)
  {
    const std::vector<int>* targetChain = targetTree.Chain(mask);
    if (!targetChain)
    {
      continue;
    }
    MatchedBranches branches;
    branches.Source = sourceChain;
    branches.Target = *targetChain;
    branches.First = addNodes(s.Origin(sourceChain.front()), t.Origin(targetChain->front()));
    branches.Last = addNodes(s.Head(sourceChain.back()), t.Head(targetChain->back()));
    match.Merges += static_cast<int>(sourceChain.size() + targetChain->size()) - 2;
    match.Branches.push_back(branches);
  }
  LeadAway(match, s, t);
  CloseLoops(match, s, t);
  AddBranchCosts(match, s, t);
  return match;
}
}
