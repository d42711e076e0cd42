// SPDX-License-Identifier: BSD-3-Clause
// The branches of a matched pair of junctions.
#include "BranchAssignment.h"
#include "BranchClusters.h"
#include "BranchLikeness.h"
#include "CorrespondenceTree.h"
#include "JunctionCost.h"
#include "LoopDirection.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// Of branches at one junction; work is bounded by it, and the right one is among the first few.
constexpr std::size_t MaximumAssignments = 6;
/// Makes a pairing impossible where there is any other.
constexpr double Forbidden = 10.0;
/// A branch of a cluster against one of none: as much as branches of a cluster may differ (λ_B).
constexpr double ClusterMismatch = 0.1;
/// Assignments rated within this of the best are tied: what branches differ by in one limb.
constexpr double Tie = 0.1;
}

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
        constexpr double opposite = 1e-9; // two unit vectors that cancel each other out
        vector = vector.norm() > opposite ? Eigen::Vector3d(vector.normalized()) : vector;
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
        unlikeness += ClusterMismatch;
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
        rating(assignment) > rating(assignments.front()) + Tie))
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
        const int targetDart = loops ? DirectLoop(this->SourceGraph, this->TargetGraph, child.Match,
                                         nodes, source.Darts[i], target.Darts[j])
                                     : target.Darts[j];
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
}
