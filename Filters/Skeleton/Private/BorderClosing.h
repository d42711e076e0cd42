// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BorderClosing_h
#define marrow_BorderClosing_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// A mesh whose borders were closed, with the values of its vertices. The vertices and triangles of
/// the original come first and keep their numbers.
struct ClosedMesh
{
  TriangleMesh Mesh;
  std::vector<Eigen::Vector3d> Position;
  std::vector<double> MSP;
};

/// Closes every border of a manifold mesh by a fan around one new vertex in its middle, so that an open
/// mesh collapses like the solid it bounds. The new vertex has the mean position and MSP of its border.
ClosedMesh CloseBorders(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& position,
  const std::vector<double>& msp);
}

#endif
