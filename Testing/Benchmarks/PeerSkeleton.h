// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PeerSkeleton_h
#define marrow_PeerSkeleton_h

#include "TriangleMesh.h"

namespace marrow::bench
{
/// CGAL's mean curvature flow skeleton with its defaults; returns its number of points, 0 if the
/// mesh is none that CGAL takes.
int PeerSkeletonSize(const TriangleMesh& mesh);
}

#endif
