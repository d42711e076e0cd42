// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshRelaxation_h
#define marrow_MeshRelaxation_h

#include "TriangleMesh.h"

#include <functional>

namespace marrow
{
/// Evens the triangles of a closed manifold mesh on the surface that `project` maps to: rounds of
/// edge flips towards a Delaunay triangulation and of tangential smoothing, each vertex projected
/// back. The number of vertices and triangles and the topology stay.
void RelaxMesh(TriangleMesh& mesh,
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& project, int rounds);
}

#endif
