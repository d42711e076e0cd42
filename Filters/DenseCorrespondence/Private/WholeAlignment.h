// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_WholeAlignment_h
#define marrow_WholeAlignment_h

#include "Guidance.h"
#include "TriangleMesh.h"

#include <Eigen/Core>

namespace marrow
{
/// The similarity that carries the target onto the source: by centroid, size and principal axes, laid
/// in the way of all 24 that brings the surfaces closest, then by closest points (ICP). What is left
/// to do for shapes whose skeletons have nothing in common. Each hint, of two vertices that correspond,
/// counts as much as the surfaces.
Eigen::Matrix<double, 3, 4> AlignWhole(const TriangleMesh& source, const TriangleMesh& target,
  const std::vector<SurfaceHint>& hints = {});
}

#endif
