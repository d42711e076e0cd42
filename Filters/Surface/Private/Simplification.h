// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Simplification_h
#define marrow_Simplification_h

#include "Progress.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// A mesh of fewer triangles, and what became of those there were.
struct SimplifiedMesh
{
  TriangleMesh Mesh;
  std::vector<int> OldVertex; ///< per vertex: the one it was before
  std::vector<int>
    VertexOfOld; ///< per old vertex: itself, or the one that it was drawn into; -1 if unused
  std::vector<int> TriangleOfOld; ///< per old triangle: itself, or -1 if it is gone
};

/// Collapses edges until at most `maximumTriangles` are left, those first that change the surface least
/// (quadrics of Garland and Heckbert 1997, with a small part of the edge's own length so that flat
/// regions keep even triangles). Vertices only vanish, none moves. What would change the topology, turn
/// a triangle over or draw it thin is not done, so a few more triangles may be left: the genus, the
/// components and the borders stay. Needs an oriented manifold and leaves one.
///
/// Works in passes over all edges, each taking the best ones: O(n log n),
/// and the order of the file plays no part but for exact ties at the same place. False if aborted.
bool SimplifyMesh(
  const TriangleMesh& mesh, int maximumTriangles, const Progress& progress, SimplifiedMesh& output);
}

#endif
