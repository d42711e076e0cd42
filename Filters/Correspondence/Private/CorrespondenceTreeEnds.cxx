// SPDX-License-Identifier: BSD-3-Clause
// The far ends of matched branches.
#include "BranchLikeness.h"
#include "CorrespondenceTree.h"
#include "JunctionCost.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// What two matched ends are worth: more than their cost, as long as that is in the usual range.
constexpr double MatchGain = 0.1;
/// Another way on is tried too where it costs no more than this share of the first.
constexpr double ClearlyBetter = 0.7;
}

std::vector<CorrespondenceTree::TreeNode> CorrespondenceTree::MatchEnds(
  const TreeNode& parent, int branches)
{
  const MatchedBranches& open = parent.Match.Branches[branches];
  const int sourceEnd = parent.Source.Features[this->SourceGraph.Head(open.Source.back())];
  const int targetEnd = parent.Target.Features[this->TargetGraph.Head(open.Target.back())];
  if (sourceEnd != Free || targetEnd != Free)
  {
    // A loop closes, or the two do not end at the same place.
    TreeNode child = parent;
    child.Match.Branches[branches].Last = sourceEnd == targetEnd && sourceEnd >= 0 ? sourceEnd : -1;
    if (child.Match.Branches[branches].Last < 0)
    {
      child.Gain -= WorthMatching;
    }
    return { child };
  }
  std::vector<TreeNode> children;
  for (const Continuation& way : this->ChooseContinuations(this->FindContinuations(parent, open)))
  {
    TreeNode child = parent;
    for (auto [side, graph, path, extension] :
      { std::tuple{ &child.Source, &this->SourceGraph, &child.Match.Branches[branches].Source,
          &way.SourcePath },
        std::tuple{ &child.Target, &this->TargetGraph, &child.Match.Branches[branches].Target,
          &way.TargetPath } })
    {
      for (int dart : *extension)
      {
        side->Features[graph->Origin(dart)] = Passed;
        side->Used[dart / 2] = true;
        path->push_back(dart);
      }
    }
    child.Match.Branches[branches].Last =
      this->AddNodes(child, way.Source, way.Target, way.IsJunction);
    child.Match.Merges += static_cast<int>(way.SourcePath.size() + way.TargetPath.size());
    this->Statistics.Merges += way.Merges;
    child.Gain += MatchGain - way.Rating;
    children.push_back(std::move(child));
  }
  return children;
}

std::vector<CorrespondenceTree::Continuation> CorrespondenceTree::FindContinuations(
  const TreeNode& node, const MatchedBranches& branches) const
{
  /// Junctions that a chain may pass; with more, most of a skeleton could be skipped.
  constexpr std::size_t maximumSkips = 3;
  // The ways on by skipping junctions, the nearest first.
  const auto waysFrom = [&](const FeatureGraph& graph, const Side& side, int lastDart)
  {
    std::vector<std::vector<int>> ways{ {} };
    std::vector<bool> seen(graph.NumberOfFeatures(), false);
    seen[graph.Head(lastDart)] = true;
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      const std::vector<int> way = ways[i];
      const int head = graph.Head(way.empty() ? lastDart : way.back());
      if (way.size() == maximumSkips)
      {
        continue;
      }
      for (int dart : graph.GetFeatures()[head].Darts)
      {
        const int next = graph.Head(dart);
        if (!side.Used[dart / 2] && side.Features[next] == Free && !seen[next])
        {
          seen[next] = true;
          ways.push_back(way);
          ways.back().push_back(dart);
        }
      }
    }
    return ways;
  };
  std::vector<Continuation> result;
  const auto sourceWays = waysFrom(this->SourceGraph, node.Source, branches.Source.back());
  const auto targetWays = waysFrom(this->TargetGraph, node.Target, branches.Target.back());
  for (const auto& s : sourceWays)
  {
    const int sourceEnd = this->SourceGraph.Head(s.empty() ? branches.Source.back() : s.back());
    for (const auto& t : targetWays)
    {
      // Skipping on both sides at once would lose a pair of junctions for nothing.
      if (!s.empty() && !t.empty())
      {
        continue;
      }
      const int targetEnd = this->TargetGraph.Head(t.empty() ? branches.Target.back() : t.back());
      const bool sourceTerminal = this->SourceGraph.GetFeatures()[sourceEnd].IsTerminal();
      const bool targetTerminal = this->TargetGraph.GetFeatures()[targetEnd].IsTerminal();
      Continuation way;
      way.SourcePath = s;
      way.TargetPath = t;
      way.Merges = static_cast<int>(s.size() + t.size());
      if (sourceTerminal != targetTerminal)
      {
        continue;
      }
      if (!sourceTerminal)
      {
        this->AddJunctionContinuations(node, way, sourceEnd, targetEnd, result);
        continue;
      }
      std::vector<int> sourcePath = branches.Source;
      sourcePath.insert(sourcePath.end(), s.begin(), s.end());
      std::vector<int> targetPath = branches.Target;
      targetPath.insert(targetPath.end(), t.begin(), t.end());
      way.Source.Features = { sourceEnd };
      way.Target.Features = { targetEnd };
      way.Cost = PathUnlikeness(this->SourceGraph, sourcePath, this->TargetGraph, targetPath);
      way.Rating = way.Cost;
      result.push_back(way);
    }
  }
  return result;
}

void CorrespondenceTree::AddJunctionContinuations(const TreeNode& node, const Continuation& paths,
  int sourceEnd, int targetEnd, std::vector<Continuation>& result) const
{
  const auto groupsFrom =
    [&](const FeatureGraph& graph, const Side& side, int feature, const std::vector<int>& path)
  {
    std::vector<bool> blocked(graph.NumberOfFeatures());
    for (int f = 0; f < graph.NumberOfFeatures(); ++f)
    {
      blocked[f] = side.Features[f] != Free;
    }
    for (int dart : path)
    {
      blocked[graph.Origin(dart)] = true;
    }
    std::vector<FeatureGroup> groups = GroupsFrom(
      graph, feature, this->Parameters.MergeDistance * graph.MeshDiagonal(), MaximumGroup, blocked);
    // What is matched already cannot vanish inside a group.
    const auto taken = [&](const FeatureGroup& group)
    {
      return std::any_of(group.Inside.begin(), group.Inside.end(),
        [&](int branch) { return static_cast<bool>(side.Used[branch]); });
    };
    groups.erase(std::remove_if(groups.begin(), groups.end(), taken), groups.end());
    return groups;
  };
  for (const FeatureGroup& s :
    groupsFrom(this->SourceGraph, node.Source, sourceEnd, paths.SourcePath))
  {
    for (const FeatureGroup& t :
      groupsFrom(this->TargetGraph, node.Target, targetEnd, paths.TargetPath))
    {
      Continuation way = paths;
      way.Source = s;
      way.Target = t;
      way.IsJunction = true;
      way.Merges += static_cast<int>(s.Features.size() + t.Features.size()) - 2;
      way.Cost = JunctionCost(this->SourceGraph, s, this->TargetGraph, t);
      way.Rating = way.Cost * (1.0 + 0.5 * way.Merges);
      result.push_back(std::move(way));
    }
  }
}

std::vector<CorrespondenceTree::Continuation> CorrespondenceTree::ChooseContinuations(
  std::vector<Continuation> all) const
{
  // The paper's order: as it is, by merging junctions, by merging more and more branches.
  const auto stage = [](const Continuation& way)
  {
    const std::size_t skipped = way.SourcePath.size() + way.TargetPath.size();
    return skipped == 0 ? (way.Merges == 0 ? 0 : 1) : 1 + static_cast<int>(skipped);
  };
  std::stable_sort(all.begin(), all.end(),
    [](const Continuation& a, const Continuation& b) { return a.Rating < b.Rating; });
  const Continuation* first = nullptr;
  for (const bool relaxed : { false, true })
  {
    const double threshold = this->Parameters.JunctionThreshold * (relaxed ? 4.0 : 1.0);
    for (const Continuation& way : all)
    {
      if (way.IsJunction && way.Cost <= threshold && (!first || stage(way) < stage(*first)))
      {
        first = &way;
      }
    }
    if (first)
    {
      break;
    }
  }
  std::vector<Continuation> result;
  if (first)
  {
    result.push_back(*first);
    for (const Continuation& way : all)
    {
      if (&way != first && way.IsJunction && result.size() < 3 &&
        way.Rating < ClearlyBetter * first->Rating)
      {
        result.push_back(way);
      }
    }
    return result;
  }
  for (const Continuation& way : all)
  {
    if (!way.IsJunction && result.size() < 2)
    {
      result.push_back(way);
    }
  }
  return result;
}
}
