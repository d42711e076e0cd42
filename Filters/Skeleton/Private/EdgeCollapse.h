// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_EdgeCollapse_h
#define marrow_EdgeCollapse_h

#include "Progress.h"
#include "Skeleton.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// Collapses the edges of a shrunk mesh greedily until no triangle is left (correspondence paper,
/// section 5, in the manner of Au et al. 2008, section 6). The vertices that were merged into one node
/// become its φ. Collapsing i onto j costs F_i(v_j) + F_j(v_j) + 0.1 |v_i - v_j| Σ_k |v_i - v_k|, F the
/// summed squared distances to the lines of the edges that were merged into the vertex.
///
/// Homotopy is held by construction: an edge annotation tells whether a collapse closes a loop that
/// does not bound. Only as many as the genus may be closed, those around the tubes: short where the
/// perimeter of the part is long. So a closed mesh of genus g gives g independent loops per component.
///
/// `closedMesh` is closed and manifold; `position` and `msp` have one value per vertex.
/// Returns the graph with positions and φ; empty when `progress` asks to stop.
SkeletonGraph CollapseToGraph(const TriangleMesh& closedMesh,
  const std::vector<Eigen::Vector3d>& position, const std::vector<double>& msp,
  const Progress& progress);
}

#endif
