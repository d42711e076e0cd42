// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BoundarySnake_h
#define marrow_BoundarySnake_h

#include "AnalyzedMesh.h"
#include "CylinderMap.h"
#include "EnclosedBranch.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// A boundary on the target: a place on the surface for every point of the source's boundary.
struct TransferredCurve
{
  std::vector<Eigen::Vector2d> Uv; ///< in the target's cylinder map, u as in the source's
  std::vector<Eigen::Vector3d> Points;
};

/// What the snake compares the target with.
struct SnakeGoal
{
  std::vector<double>
    Offsets; ///< per point: the source's offset from its fitting plane, in target units
  std::vector<double> DihedralAngles; ///< per point: the source's, radians
  FittingPlane Plane;                 ///< the target's
  double SearchRadius = 0.0;          ///< target units
  double DihedralTolerance = 0.1;     ///< λ, radians
};

/// T:4.4. Snaxels lie on edges and vertices of the target: each point may move along its line of
/// constant u to where that crosses an edge, within the search radius. The energy is
/// E_feature + E_shape per point plus the snake's own stiffness, the change of displacement between
/// neighbours; the best closed curve is found by dynamic programming, not by descent, so there is no
/// local minimum to be caught in. Distances to features are straight: the search region is small.
void RefineCurve(const AnalyzedMesh& target, const CylinderMap& map, const SnakeGoal& goal,
  TransferredCurve& curve);
}

#endif
