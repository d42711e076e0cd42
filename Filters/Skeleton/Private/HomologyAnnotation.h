// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_HomologyAnnotation_h
#define marrow_HomologyAnnotation_h

#include "TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace marrow
{
/// The class of a loop in the first homology (coefficients 0 and 1) of a surface, as a row of bits.
using HomologyClass = std::vector<std::uint64_t>;

/// Annotates every half-edge of a closed surface with 2 · genus bits such that the exclusive or along
/// a loop of edges is zero exactly when the loop bounds on the surface (Busaryev, Cabello, Chen, Dey
/// and Wang, "Annotating simplices with a homology basis", SWAT 2012). Both half-edges of an edge
/// have the same bits. On a surface of genus 0 the rows are empty.
///
/// The bits come from a spanning tree of the vertices and one of the triangles that does not cross
/// it: each of the 2 · genus edges in neither closes a loop of triangles, and an edge's bit tells
/// whether that loop crosses it. O(n · genus).
std::vector<HomologyClass> AnnotateHalfEdges(const TriangleMesh& closedMesh);
}

#endif
