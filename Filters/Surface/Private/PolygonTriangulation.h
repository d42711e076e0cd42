// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PolygonTriangulation_h
#define marrow_PolygonTriangulation_h

#include "MendedMesh.h"
#include "PolygonMesh.h"

#include <array>
#include <vector>

namespace marrow
{
/// Cuts a polygon of n >= 3 corners into n - 2 triangles along its diagonals, by ear clipping in the
/// plane that fits it best, the shortest diagonal first. Concave polygons are cut inside. One that
/// crosses itself has no such cut: it still gives n - 2 triangles, but they overlap.
std::vector<std::array<int, 3>> TriangulatePolygon(const std::vector<Eigen::Vector3d>& corners);

/// The polygons as triangles that take their place in the same order. A corner that comes twice in
/// succession counts once; a polygon that is left with fewer than three has no triangle. Returns how
/// many polygons were cut.
int TriangulatePolygons(const PolygonMesh& input, MendedMesh& output);
}

#endif
