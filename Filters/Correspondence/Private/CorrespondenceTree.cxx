// SPDX-License-Identifier: BSD-3-Clause
#include "CorrespondenceTree.h"

#include "BranchAssignment.h"
#include "BranchClusters.h"
#include "BranchLikeness.h"
#include "JunctionCost.h"
#include "LinearAssignment.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
constexpr std::size_t MaximumLevelWidth = 48;
constexpr std::size_t MaximumCorePairs = 8;
constexpr std::size_t MaximumAssignments = 6;
constexpr int MaximumGroup = 4;
/// A pair of branches that is less like than this is rather a loss than a gain.
constexpr double WorthMatching = 0.5;
/// Makes a pairing impossible where there is any other.
constexpr double Forbidden = 10.0;
}

CorrespondenceTree::CorrespondenceTree(
  const FeatureGraph& source, const FeatureGraph& target, const TreeParameters& parameters)
  : SourceGraph(source)
  , TargetGraph(target)
  , Parameters(parameters)
{
  this->PairComponents();
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
  if (node.Match.Branches.empty() && node.Match.Nodes.empty())
  {
    return;
  }
  const auto same = [&](const FeatureCorrespondence& other)
  {
    const auto& mine = node.Match;
    return std::equal(mine.Nodes.begin(), mine.Nodes.end(), other.Nodes.begin(), other.Nodes.end(),
             [](const MatchedNodes& a, const MatchedNodes& b)
             { return a.Source == b.Source && a.Target == b.Target; }) &&
      std::equal(mine.Branches.begin(), mine.Branches.end(), other.Branches.begin(),
        other.Branches.end(),
        [](const MatchedBranches& a, const MatchedBranches& b)
        { return a.Source == b.Source && a.Target == b.Target; });
  };
  if (std::none_of(this->Leaves.begin(), this->Leaves.end(), same))
  {
    this->Leaves.push_back(node.Match);
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

// -- Where a component begins ---------------------------------------------------------------------

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

// -- The branches of a matched pair of junctions
// ----------------------------------------------------

std::vector<CorrespondenceTree::TreeNode> CorrespondenceTree::MatchBranches(
  const TreeNode& node, int nodes)
{
  const MatchedNodes& pair = node.Match.Nodes[nodes];
  struct OpenBranches
  {
    std::vector<int> Darts;
    std::vector<double> Sizes;
    std::vector<bool> IsLoop;
    std::vector<Eigen::Vector3d> Vectors;
    std::vector<int> Clusters;
  };
  const auto open = [&](const FeatureGraph& graph, const FeatureGroup& group, const Side& side)
  {
    OpenBranches result;
    const std::vector<int> all = graph.OpenDarts(group);
    const std::vector<double> sizes = graph.SubSkeletonSizes(group, all);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const bool loop = group.Contains(graph.Head(all[i]));
      // A loop stands once, by the dart that the feature graph lists first.
      if (side.Used[all[i] / 2] || (loop && all[i] % 2 == 1))
      {
        continue;
      }
      Eigen::Vector3d vector = graph.Direction(group, all[i]);
      if (loop)
      {
        vector += graph.Direction(group, all[i] ^ 1);
        vector = vector.norm() > 1e-9 ? Eigen::Vector3d(vector.normalized()) : vector;
      }
      result.Darts.push_back(all[i]);
      result.Sizes.push_back(sizes[i]);
      result.IsLoop.push_back(loop);
      result.Vectors.push_back(vector);
    }
    result.Clusters = ClusterBranches(graph, result.Darts, this->Parameters.ClusterDistance);
    return result;
  };
  const OpenBranches source = open(this->SourceGraph, pair.Source, node.Source);
  const OpenBranches target = open(this->TargetGraph, pair.Target, node.Target);
  if (source.Darts.empty() || target.Darts.empty())
  {
    return {};
  }
  this->Statistics.Clusters +=
    NumberOfClusters(source.Clusters) + NumberOfClusters(target.Clusters);

  BranchSets sets;
  sets.Source = source.Vectors;
  sets.Target = target.Vectors;
  for (const MatchedBranches& known : node.Match.Branches)
  {
    if (known.First == nodes)
    {
      sets.KnownSource.push_back(this->SourceGraph.Direction(pair.Source, known.Source.front()));
      sets.KnownTarget.push_back(this->TargetGraph.Direction(pair.Target, known.Target.front()));
    }
    if (known.Last == nodes)
    {
      sets.KnownSource.push_back(this->SourceGraph.Direction(pair.Source, known.Source.back() ^ 1));
      sets.KnownTarget.push_back(this->TargetGraph.Direction(pair.Target, known.Target.back() ^ 1));
    }
  }
  sets.Unlikeness.resize(source.Darts.size(), target.Darts.size());
  for (std::size_t i = 0; i < source.Darts.size(); ++i)
  {
    for (std::size_t j = 0; j < target.Darts.size(); ++j)
    {
      double unlikeness = std::abs(source.Sizes[i] - target.Sizes[j]) +
        PathUnlikeness(
          this->SourceGraph, { source.Darts[i] }, this->TargetGraph, { target.Darts[j] });
      if (source.IsLoop[i] != target.IsLoop[j])
      {
        unlikeness += Forbidden;
      }
      if ((source.Clusters[i] < 0) != (target.Clusters[j] < 0))
      {
        unlikeness += 0.1;
      }
      sets.Unlikeness(static_cast<int>(i), static_cast<int>(j)) = unlikeness;
    }
  }

  std::vector<BranchAssignment> assignments = FindAssignments(sets);
  const double fewer = static_cast<double>(std::min(source.Darts.size(), target.Darts.size()));
  const auto rating = [&](const BranchAssignment& a)
  { return (2.0 * a.SpatialCost + a.Unlikeness) / fewer; };
  std::stable_sort(assignments.begin(), assignments.end(),
    [&](const BranchAssignment& a, const BranchAssignment& b) { return rating(a) < rating(b); });
  const double structure =
    StructureCost(this->SourceGraph, pair.Source, this->TargetGraph, pair.Target);
  const std::size_t tenth = std::min(assignments.size() / 10, MaximumAssignments);
  std::vector<TreeNode> children;
  for (const BranchAssignment& assignment : assignments)
  {
    if (children.size() == MaximumAssignments ||
      (!children.empty() && children.size() >= tenth &&
        rating(assignment) > rating(assignments.front()) + 0.1))
    {
      break;
    }
    TreeNode child = node;
    // Loops last: the others tell their direction.
    for (const bool loops : { false, true })
    {
      for (std::size_t i = 0; i < source.Darts.size(); ++i)
      {
        const int j = assignment.TargetOfSource[i];
        if (j < 0 || source.IsLoop[i] != loops || target.IsLoop[j] != loops)
        {
          continue;
        }
        int targetDart = target.Darts[j];
        if (loops)
        {
          this->OrientLoop(child, nodes, source.Darts[i], targetDart);
        }
        this->AddBranches(child, { source.Darts[i] }, { targetDart }, nodes);
        child.Gain += WorthMatching - sets.Unlikeness(static_cast<int>(i), j);
      }
    }
    child.Gain -= 2.0 * assignment.SpatialCost;
    child.Match.BranchCosts.push_back(
      (structure + CostEpsilon) * (assignment.SpatialCost + CostEpsilon));
    children.push_back(std::move(child));
  }
  return children;
}

void CorrespondenceTree::OrientLoop(
  const TreeNode& node, int nodes, int sourceDart, int& targetDart) const
{
  const MatchedNodes& pair = node.Match.Nodes[nodes];
  double least = 0.0;
  int best = -1;
  for (int dart : { targetDart, targetDart ^ 1 })
  {
    std::vector<Eigen::Vector3d> p;
    std::vector<Eigen::Vector3d> q;
    const auto add = [&](int s, int t)
    {
      p.push_back(this->SourceGraph.Direction(pair.Source, s));
      q.push_back(this->TargetGraph.Direction(pair.Target, t));
    };
    add(sourceDart, dart);
    add(sourceDart ^ 1, dart ^ 1);
    for (const MatchedBranches& known : node.Match.Branches)
    {
      if (known.First == nodes)
      {
        add(known.Source.front(), known.Target.front());
      }
      if (known.Last == nodes)
      {
        add(known.Source.back() ^ 1, known.Target.back() ^ 1);
      }
    }
    Eigen::Matrix3d rotation;
    const bool proper = BestRotation(p, q, rotation);
    double cost = PathUnlikeness(this->SourceGraph, { sourceDart }, this->TargetGraph, { dart }) +
      (proper ? 0.0 : 0.1);
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      cost += 0.1 * (p[i] - rotation * q[i]).squaredNorm();
    }
    if (best < 0 || cost < least)
    {
      least = cost;
      best = dart;
    }
  }
  targetDart = best;
}

// -- The far ends of matched branches
// ----------------------------------------------------------------

std::vector<CorrespondenceTree::TreeNode> CorrespondenceTree::MatchEnds(
  const TreeNode& parent, int branches)
{
  const MatchedBranches& open = parent.Match.Branches[branches];
  const int sourceEnd = parent.Source.Features[this->SourceGraph.Head(open.Source.back())];
  const int targetEnd = parent.Target.Features[this->TargetGraph.Head(open.Target.back())];
  if (sourceEnd != Free || targetEnd != Free)
  {
    // A loop closes, or the two do not end at the same place: they keep their beginning only.
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
    child.Gain += 0.1 - way.Rating;
    children.push_back(std::move(child));
  }
  return children;
}

std::vector<CorrespondenceTree::Continuation> CorrespondenceTree::FindContinuations(
  const TreeNode& node, const MatchedBranches& branches) const
{
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
      if (&way != first && way.IsJunction && result.size() < 3 && way.Rating < 0.7 * first->Rating)
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
