// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceMending_h
#define marrow_SurfaceMending_h

#include "MendedMesh.h"
#include "PolygonMesh.h"
#include "SurfaceReport.h"

#include <vector>

namespace marrow
{
/// What came of mending.
struct Mending
{
  MendedMesh Result;               ///< an oriented manifold with its connectivity; no unused vertex
  std::vector<int> Representative; ///< per input point: the one it was merged into
  std::vector<int> TwinOfCell;     ///< the cell that stays of two in one place; -1 for all others
};

/// All steps that keep the resolution, one after the other; counts in the report what each did. The
/// mesh has passed CheckInput.
void MendSurface(const PolygonMesh& input, Mending& mending, SurfaceReport& report);
}

#endif
