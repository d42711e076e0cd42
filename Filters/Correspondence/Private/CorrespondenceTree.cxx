// SPDX-License-Identifier: BSD-3-Clause
#include "CorrespondenceTree.h"

#include "JunctionCost.h"

#include <algorithm>

namespace marrow
{
namespace
{
/// Nodes that a level of the tree keeps.
constexpr std::size_t MaximumLevelWidth = 48;
}

CorrespondenceTree::CorrespondenceTree(
  const FeatureGraph& source, const FeatureGraph& target, const TreeParameters& parameters)
  : SourceGraph(source)
  , TargetGraph(target)
  , Parameters(parameters)
{
  this->PairComponents();
}

bool CorrespondenceTree::Grow(const Progress& progress)
{
  TreeNode root;
  root.Source.Features.assign(this->SourceGraph.NumberOfFeatures(), Free);
  root.Source.Used.assign(this->SourceGraph.NumberOfBranches(), false);
  root.Target.Features.assign(this->TargetGraph.NumberOfFeatures(), Free);
  root.Target.Used.assign(this->TargetGraph.NumberOfBranches(), false);
  this->Statistics.TreeNodes = 1;

  const double features =
    this->SourceGraph.NumberOfFeatures() + this->TargetGraph.NumberOfFeatures();
  std::vector<TreeNode> level{ root };
  for (int depth = 0; !level.empty(); ++depth)
  {
    this->Statistics.Height = depth;
    std::vector<TreeNode> next;
    for (TreeNode& node : level)
    {
      if (!Report(progress, 1.0 - 1.0 / (1.0 + 4.0 * depth / features)))
      {
        return false;
      }
      std::vector<TreeNode> children = this->Expand(node);
      if (children.empty())
      {
        this->AddLeaf(node);
      }
      for (TreeNode& child : children)
      {
        next.push_back(std::move(child));
      }
    }
    std::stable_sort(next.begin(), next.end(),
      [](const TreeNode& a, const TreeNode& b) { return a.Gain > b.Gain; });
    if (next.size() > MaximumLevelWidth)
    {
      next.resize(MaximumLevelWidth);
    }
    this->Statistics.TreeNodes += static_cast<int>(next.size());
    level = std::move(next);
  }
  this->Statistics.Leaves = static_cast<int>(this->Leaves.size());
  return true;
}

std::vector<CorrespondenceTree::TreeNode> CorrespondenceTree::Expand(TreeNode& node)
{
  while (node.NextTask < node.Tasks.size())
  {
    const Task task = node.Tasks[node.NextTask++];
    std::vector<TreeNode> children =
      task.IsJunction ? this->MatchBranches(node, task.Index) : this->MatchEnds(node, task.Index);
    if (children.size() == 1 && children[0].Match.JunctionCosts == node.Match.JunctionCosts &&
      !task.IsJunction)
    {
      // Two terminals met, or a loop closed: no step of its own in the tree.
      node = std::move(children[0]);
    }
    else if (!children.empty())
    {
      return children;
    }
  }
  while (node.NextComponent < this->Components.size())
  {
    std::vector<TreeNode> children = this->StartComponent(node);
    ++node.NextComponent;
    if (!children.empty())
    {
      return children;
    }
  }
  return {};
}

void CorrespondenceTree::AddLeaf(const TreeNode& node)
{
  FeatureCorrespondence leaf = node.Match;
  // Branches whose far ends are different parts after all are not the same part themselves.
  leaf.Branches.erase(std::remove_if(leaf.Branches.begin(), leaf.Branches.end(),
                        [](const MatchedBranches& branches) { return branches.Last < 0; }),
    leaf.Branches.end());
  if (leaf.Nodes.empty())
  {
    return;
  }
  const auto same = [&](const FeatureCorrespondence& other)
  {
    return std::equal(leaf.Nodes.begin(), leaf.Nodes.end(), other.Nodes.begin(), other.Nodes.end(),
             [](const MatchedNodes& a, const MatchedNodes& b)
             { return a.Source == b.Source && a.Target == b.Target; }) &&
      std::equal(leaf.Branches.begin(), leaf.Branches.end(), other.Branches.begin(),
        other.Branches.end(),
        [](const MatchedBranches& a, const MatchedBranches& b)
        { return a.Source == b.Source && a.Target == b.Target; });
  };
  if (std::none_of(this->Leaves.begin(), this->Leaves.end(), same))
  {
    this->Leaves.push_back(std::move(leaf));
  }
}

int CorrespondenceTree::AddNodes(
  TreeNode& node, const FeatureGroup& source, const FeatureGroup& target, bool isJunction) const
{
  const int index = static_cast<int>(node.Match.Nodes.size());
  MatchedNodes nodes;
  nodes.Source = source;
  nodes.Target = target;
  if (isJunction)
  {
    nodes.Cost = JunctionCost(this->SourceGraph, source, this->TargetGraph, target);
    node.Match.JunctionCosts.push_back(nodes.Cost);
    node.Match.Merges += static_cast<int>(source.Features.size() + target.Features.size()) - 2;
    node.Tasks.push_back({ true, index });
  }
  node.Match.Nodes.push_back(nodes);
  for (auto [side, group] :
    { std::pair{ &node.Source, &source }, std::pair{ &node.Target, &target } })
  {
    for (int feature : group->Features)
    {
      side->Features[feature] = index;
    }
    for (int branch : group->Inside)
    {
      side->Used[branch] = true;
    }
  }
  return index;
}

void CorrespondenceTree::AddBranches(
  TreeNode& node, const std::vector<int>& source, const std::vector<int>& target, int first) const
{
  const int index = static_cast<int>(node.Match.Branches.size());
  node.Match.Branches.push_back({ source, target, first, -1 });
  for (int dart : source)
  {
    node.Source.Used[dart / 2] = true;
  }
  for (int dart : target)
  {
    node.Target.Used[dart / 2] = true;
  }
  node.Tasks.push_back({ false, index });
}
}
