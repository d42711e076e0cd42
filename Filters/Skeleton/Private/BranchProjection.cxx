// SPDX-License-Identifier: BSD-3-Clause
#include "BranchProjection.h"

#include <algorithm>

namespace marrow
{
BranchProjection ProjectNear(
  const Eigen::Vector3d& point, const Skeleton& skeleton, const Branch& branch, int step)
{
  /// Segments that a step may jump over: more would take short cuts through bends.
  constexpr int Reach = 3;
  const int firstSegment = std::max(0, step - Reach);
  const int lastSegment = std::min(static_cast<int>(branch.Nodes.size()) - 2, step + Reach - 1);
  BranchProjection best;
  for (int i = firstSegment; i <= lastSegment; ++i)
  {
    const Eigen::Vector3d& a = skeleton.Graph[branch.Nodes[i]].Position;
    const Eigen::Vector3d& b = skeleton.Graph[branch.Nodes[i + 1]].Position;
    const Eigen::Vector3d d = b - a;
    const double squaredLength = d.squaredNorm();
    const double t =
      squaredLength > 0.0 ? std::clamp((point - a).dot(d) / squaredLength, 0.0, 1.0) : 0.0;
    // The same bits from either side of a node.
    const Eigen::Vector3d nearest = t < 1.0 ? Eigen::Vector3d(a + t * d) : b;
    const double squaredDistance = (nearest - point).squaredNorm();
    if (squaredDistance < best.SquaredDistance)
    {
      best.SquaredDistance = squaredDistance;
      best.Arc = branch.ArcLength[i] + t * (branch.ArcLength[i + 1] - branch.ArcLength[i]);
    }
  }
  return best;
}
}
