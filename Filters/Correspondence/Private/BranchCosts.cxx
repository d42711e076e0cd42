// SPDX-License-Identifier: BSD-3-Clause
#include "BranchCosts.h"

#include "BranchAssignment.h"
#include "JunctionCost.h"

#include <vector>

namespace marrow
{
void AddBranchCosts(
  FeatureCorrespondence& match, const FeatureGraph& source, const FeatureGraph& target)
{
  for (std::size_t i = 0; i < match.Nodes.size(); ++i)
  {
    const MatchedNodes& nodes = match.Nodes[i];
    std::vector<Eigen::Vector3d> p;
    std::vector<Eigen::Vector3d> q;
    const auto add = [&](int sourceDart, int targetDart)
    {
      p.push_back(source.Direction(nodes.Source, sourceDart));
      q.push_back(target.Direction(nodes.Target, targetDart));
    };
    for (const MatchedBranches& branches : match.Branches)
    {
      if (branches.First == static_cast<int>(i))
      {
        add(branches.Source.front(), branches.Target.front());
      }
      if (branches.Last == static_cast<int>(i))
      {
        add(branches.Source.back() ^ 1, branches.Target.back() ^ 1);
      }
    }
    if (p.size() > 1)
    {
      match.BranchCosts.push_back(
        (StructureCost(source, nodes.Source, target, nodes.Target) + CostEpsilon) *
        (SpatialCost(p, q) + CostEpsilon));
    }
  }
}
}
