// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_WindingNumber_h
#define marrow_WindingNumber_h

#include "TriangleMesh.h"

namespace marrow
{
/// How often the surface winds around a point: 1 inside a closed mesh, 0 outside, in between near the
/// holes of an open one (Jacobson, Kavan and Sorkine 2013). O(triangles).
double WindingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point);
}

#endif
