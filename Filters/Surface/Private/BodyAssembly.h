// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BodyAssembly_h
#define marrow_BodyAssembly_h

#include "Progress.h"
#include "SurfaceReport.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The bodies of a mended mesh: what is left when inner parts and crumbs are left out and parts that
/// belong together are united.
struct BodyAssembly
{
  bool IsWhole = false; ///< nothing was to do; all below is empty
  TriangleMesh Mesh;
  int MostFaces = 0; ///< of the working surface: what was drawn anew needs fewer than it has
  std::vector<int> TriangleOfFull; ///< per triangle of the mended mesh: the same, or the nearest
  std::vector<int> VertexOfFull;   ///< per vertex of the mended mesh: the same, or the nearest
  std::vector<int> FullOfVertex;   ///< and back
};

/// `maximumFaces` of the working surface says how finely parts are wrapped, how near is touching, and
/// what is too small for a body. False if aborted.
bool AssembleBodies(const TriangleMesh& full, int maximumFaces, const Progress& progress,
  BodyAssembly& assembly, SurfaceReport& report);
}

#endif
