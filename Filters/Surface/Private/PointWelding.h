// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PointWelding_h
#define marrow_PointWelding_h

#include "MendedMesh.h"

#include <vector>

namespace marrow
{
/// For every point the first one with the same coordinates (0 and -0 are the same). O(n).
std::vector<int> FirstEqualPoint(const std::vector<Eigen::Vector3d>& points);

/// Merges points at the same place where that lays open edges onto each other: texture seams, and
/// files such as STL whose faces share no points at all. All other points stay their own, as there is
/// nothing to close; so parts that touch do not grow together.
///
/// Then the same for points of open edges that differ in nothing but the rounding of their coordinates:
/// by one unit in the last place of the largest coordinate at most, in the precision that the
/// coordinates have (single if all of them are single precision numbers). Points that an open edge
/// joins stay apart.
///
/// `representative` gets the point that every point became. Returns how many were merged.
int WeldPoints(MendedMesh& mesh, std::vector<int>& representative);
}

#endif
