// SPDX-License-Identifier: BSD-3-Clause
// Where the tree begins: components, core junctions, paths of what has no junction.
#include "BranchLikeness.h"
#include "CorrespondenceTree.h"
#include "JunctionCost.h"
#include "LinearAssignment.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// Pairs of junctions that a tree begins with; work is bounded by it, and each pair grows a subtree.
constexpr std::size_t MaximumCorePairs = 8;
}

void CorrespondenceTree::PairComponents()
{
  const int sources = this->SourceGraph.NumberOfComponents();
  const int targets = this->TargetGraph.NumberOfComponents();
  const auto shape = [](const FeatureGraph& graph, int component)
  {
    Eigen::Vector3d result(graph.ComponentLength(component), 0.0, 0.0);
    double features = 0.0;
    double junctions = 0.0;
    for (const auto& feature : graph.GetFeatures())
    {
      if (feature.Component == component)
      {
        features += 1.0;
        junctions += feature.IsJunction() ? 1.0 : 0.0;
        result[2] += feature.AGD;
      }
    }
    result[1] = junctions / graph.NumberOfFeatures();
    result[2] /= features;
    return result;
  };
  Eigen::MatrixXd cost(sources, targets);
  for (int s = 0; s < sources; ++s)
  {
    for (int t = 0; t < targets; ++t)
    {
      cost(s, t) = (shape(this->SourceGraph, s) - shape(this->TargetGraph, t)).lpNorm<1>();
    }
  }
  const std::vector<int> targetOf = AssignRows(cost);
  for (int s = 0; s < sources; ++s)
  {
    if (targetOf[s] >= 0)
    {
      this->Components.emplace_back(s, targetOf[s]);
    }
  }
}

std::vector<CorrespondenceTree::TreeNode> CorrespondenceTree::StartComponent(const TreeNode& node)
{
  const auto [source, target] = this->Components[node.NextComponent];
  std::vector<TreeNode> children = this->StartAtJunctions(node, source, target);
  if (children.empty())
  {
    children = this->StartAlongPaths(node, source, target);
  }
  for (TreeNode& child : children)
  {
    ++child.NextComponent;
  }
  this->Statistics.CorePairs += static_cast<int>(children.size());
  return children;
}

std::vector<CorrespondenceTree::TreeNode> CorrespondenceTree::StartAtJunctions(
  const TreeNode& node, int source, int target)
{
  const auto groupsOf = [&](const FeatureGraph& graph, int component)
  {
    std::vector<FeatureGroup> groups = JunctionGroups(
      graph, component, this->Parameters.MergeDistance * graph.MeshDiagonal(), MaximumGroup);
    // A ring without a junction begins at its promoted node.
    for (int f = 0; f < graph.NumberOfFeatures(); ++f)
    {
      if (graph.GetFeatures()[f].Component == component && graph.GetFeatures()[f].Darts.size() == 2)
      {
        groups.push_back(FeatureGroup{ { f }, {} });
      }
    }
    return groups;
  };
  struct CorePair
  {
    const FeatureGroup* Source;
    const FeatureGroup* Target;
    double Cost;
    std::size_t Merges;
  };
  const std::vector<FeatureGroup> sources = groupsOf(this->SourceGraph, source);
  const std::vector<FeatureGroup> targets = groupsOf(this->TargetGraph, target);
  std::vector<CorePair> pairs;
  for (const FeatureGroup& s : sources)
  {
    for (const FeatureGroup& t : targets)
    {
      pairs.push_back({ &s, &t, JunctionCost(this->SourceGraph, s, this->TargetGraph, t),
        s.Features.size() + t.Features.size() - 2 });
    }
  }
  const auto rating = [](const CorePair& pair)
  { return pair.Cost * (1.0 + 0.25 * static_cast<double>(pair.Merges)); };
  std::stable_sort(pairs.begin(), pairs.end(),
    [&](const CorePair& a, const CorePair& b) { return rating(a) < rating(b); });
  std::vector<TreeNode> children;
  for (const CorePair& pair : pairs)
  {
    if (children.size() == MaximumCorePairs ||
      (children.size() >= 3 && rating(pair) > 4.0 * rating(pairs.front())))
    {
      break;
    }
    TreeNode child = node;
    this->AddNodes(child, *pair.Source, *pair.Target, true);
    this->Statistics.Merges += static_cast<int>(pair.Merges);
    children.push_back(std::move(child));
  }
  return children;
}

std::vector<CorrespondenceTree::TreeNode> CorrespondenceTree::StartAlongPaths(
  const TreeNode& node, int source, int target)
{
  // All simple paths from terminal to terminal, one of each pair.
  const auto pathsOf = [](const FeatureGraph& graph, int component)
  {
    std::vector<std::vector<int>> paths;
    for (int start = 0; start < graph.NumberOfFeatures(); ++start)
    {
      const auto& feature = graph.GetFeatures()[start];
      if (feature.Component != component || !feature.IsTerminal())
      {
        continue;
      }
      std::vector<std::vector<int>> open{ { feature.Darts.front() } };
      std::vector<bool> seen(graph.NumberOfFeatures(), false);
      seen[start] = true;
      for (std::size_t i = 0; i < open.size(); ++i)
      {
        const std::vector<int> path = open[i];
        const int head = graph.Head(path.back());
        if (seen[head])
        {
          continue;
        }
        seen[head] = true;
        if (graph.GetFeatures()[head].IsTerminal())
        {
          if (start < head)
          {
            paths.push_back(path);
          }
          continue;
        }
        for (int dart : graph.GetFeatures()[head].Darts)
        {
          open.push_back(path);
          open.back().push_back(dart);
        }
      }
    }
    return paths;
  };
  struct Candidate
  {
    std::vector<int> Source;
    std::vector<int> Target;
    double Unlikeness;
  };
  std::vector<Candidate> candidates;
  for (const auto& s : pathsOf(this->SourceGraph, source))
  {
    for (auto t : pathsOf(this->TargetGraph, target))
    {
      for (int direction = 0; direction < 2; ++direction)
      {
        candidates.push_back({ s, t, PathUnlikeness(this->SourceGraph, s, this->TargetGraph, t) });
        std::reverse(t.begin(), t.end());
        for (int& dart : t)
        {
          dart ^= 1;
        }
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Unlikeness < b.Unlikeness; });
  std::vector<TreeNode> children;
  for (const Candidate& candidate : candidates)
  {
    if (children.size() == MaximumCorePairs)
    {
      break;
    }
    TreeNode child = node;
    const auto group = [](int feature) { return FeatureGroup{ { feature }, {} }; };
    const int first = this->AddNodes(child, group(this->SourceGraph.Origin(candidate.Source[0])),
      group(this->TargetGraph.Origin(candidate.Target[0])), false);
    this->AddBranches(child, candidate.Source, candidate.Target, first);
    for (auto [side, graph, path] :
      { std::tuple{ &child.Source, &this->SourceGraph, &candidate.Source },
        std::tuple{ &child.Target, &this->TargetGraph, &candidate.Target } })
    {
      for (std::size_t i = 1; i < path->size(); ++i)
      {
        side->Features[graph->Origin((*path)[i])] = Passed;
      }
    }
    child.Match.Merges += static_cast<int>(candidate.Source.size() + candidate.Target.size()) - 2;
    // The pair's likeness stands where a junction pair has its cost of branches.
    child.Match.BranchCosts.push_back(candidate.Unlikeness + CostEpsilon);
    child.Gain += WorthMatching - candidate.Unlikeness;
    children.push_back(std::move(child));
  }
  return children;
}
}
