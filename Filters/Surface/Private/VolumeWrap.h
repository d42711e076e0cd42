// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_VolumeWrap_h
#define marrow_VolumeWrap_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The surface of the volume that some triangles of a mesh enclose together, on a grid of `spacing`:
/// where they wind more than half around a point is inside (Jacobson et al. 2013). Parts that overlap
/// become one, inner parts vanish, openings are closed as a soap film would. Where the triangles do not
/// agree on an inside, so that less than half of them lie on that surface, it is drawn around them at
/// the distance of one grid cell instead. The grid is made coarser where it would have more than
/// `mostCells` along a side. An oriented closed manifold; cavities are left out.
TriangleMesh WrapVolume(
  const TriangleMesh& mesh, const std::vector<int>& triangles, double spacing, int mostCells);
}

#endif
