// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BranchProjection_h
#define marrow_BranchProjection_h

#include "Skeleton.h"

#include <limits>

namespace marrow
{
/// The place on a branch nearest to a point.
struct BranchProjection
{
  double SquaredDistance = std::numeric_limits<double>::infinity();
  double Arc = 0.0;
};

/// Projects `point` to the segments of `branch` that are within three nodes of its node number `step`:
/// on a branch that bends back on itself a vertex must not be taken for one of the other arm.
BranchProjection ProjectNear(
  const Eigen::Vector3d& point, const Skeleton& skeleton, const Branch& branch, int step);
}

#endif
