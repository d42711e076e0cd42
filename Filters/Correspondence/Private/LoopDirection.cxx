// SPDX-License-Identifier: BSD-3-Clause
#include "LoopDirection.h"

#include "BranchAssignment.h"
#include "BranchLikeness.h"

namespace marrow
{
namespace
{
/// Of where branches point, beside how MSP runs along them, which tells the direction of a loop better.
constexpr double WeightOfDirections = 0.1;
}

int DirectLoop(const FeatureGraph& source, const FeatureGraph& target,
  const FeatureCorrespondence& match, int nodes, int sourceDart, int targetDart)
{
  const MatchedNodes& pair = match.Nodes[nodes];
  double least = 0.0;
  int best = -1;
  for (int dart : { targetDart, targetDart ^ 1 })
  {
    std::vector<Eigen::Vector3d> p;
    std::vector<Eigen::Vector3d> q;
    const auto add = [&](int s, int t)
    {
      p.push_back(source.Direction(pair.Source, s));
      q.push_back(target.Direction(pair.Target, t));
    };
    add(sourceDart, dart);
    add(sourceDart ^ 1, dart ^ 1);
    for (const MatchedBranches& known : match.Branches)
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
    double cost = PathUnlikeness(source, { sourceDart }, target, { dart }) +
      (proper ? 0.0 : WeightOfDirections);
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      cost += WeightOfDirections * (p[i] - rotation * q[i]).squaredNorm();
    }
    if (best < 0 || cost < least)
    {
      least = cost;
      best = dart;
    }
  }
  return best;
}
}
