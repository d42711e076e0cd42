// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeanCurvatureSkeleton_h
#define marrow_MeanCurvatureSkeleton_h

#include "Progress.h"
#include "Skeleton.h"
#include "TriangleMesh.h"

#include <string>

namespace marrow
{
/// CGAL's weights of the contraction and their defaults.
struct MeanCurvatureWeights
{
  double QualitySpeedTradeoff = 0.1;          ///< w_H, > 0
  double MediallyCenteredSpeedTradeoff = 0.2; ///< w_M; 0: the medial axis is left out
};

/// CGAL's mean curvature flow skeleton of a closed, connected, manifold mesh: nodes, φ and positions
/// as CGAL gives them, and the branches. Returns one sentence that says what is wrong, or an empty
/// one; `skeleton` is left without nodes after an error and when `progress` asks to stop.
std::string ComputeMeanCurvatureSkeleton(const TriangleMesh& mesh,
  const MeanCurvatureWeights& weights, Skeleton& skeleton, const Progress& progress);
}

#endif
