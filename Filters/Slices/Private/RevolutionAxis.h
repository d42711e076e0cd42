// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_RevolutionAxis_h
#define marrow_RevolutionAxis_h

#include "TriangleMesh.h"

#include <Eigen/Core>

namespace marrow
{
/// The line about which a surface can best be turned within itself.
struct RevolutionAxis
{
  Eigen::Vector3d Point = Eigen::Vector3d::Zero();
  Eigen::Vector3d Direction = Eigen::Vector3d::UnitZ();
};

/// The normals of a surface of revolution all meet its axis, so the axis is found from a linear system
/// over the triangles (Pottmann, Wallner 2001), solved again with less weight on what does not turn
/// with the rest, as handles.
RevolutionAxis FindRevolutionAxis(const TriangleMesh& mesh);
}

#endif
