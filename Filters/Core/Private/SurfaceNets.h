// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceNets_h
#define marrow_SurfaceNets_h

#include "TriangleMesh.h"

#include <functional>

namespace marrow
{
/// Triangulates the zero set of `function` (negative inside) on a grid, after Gibson's surface
/// nets: one vertex in every cell that the surface crosses, a quadrilateral around every grid edge
/// that it crosses. Chosen before marching cubes as its triangles are even and come in the same
/// number per area everywhere. `function` must change no faster than distance does: whole blocks
/// are left out on the strength of their middle, and where it does change faster holes may be left. The result is oriented outward and its
/// connectivity is built; in rare cells, where sheets meet across an ambiguous face on both sides,
/// it is not manifold.
TriangleMesh SurfaceNets(const std::function<double(const Eigen::Vector3d&)>& function,
  const Eigen::Vector3d& low, const Eigen::Vector3d& high, double spacing);
}

#endif
