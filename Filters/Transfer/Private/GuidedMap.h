// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_GuidedMap_h
#define marrow_GuidedMap_h

#include "AnalyzedMesh.h"
#include "MeshSmoother.h"
#include "Progress.h"
#include "SegmentLoops.h"
#include "SkeletonMap.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// Where every vertex of the target lies on the source, by the skeletons alone: good for any
/// boundary, round one branch, several or none, but only as exact as the skeletons.
struct GuidedMap
{
  std::vector<Eigen::Vector3d> Positions;   ///< per target vertex, in the source's space
  std::vector<Eigen::Vector3d> FoundPoints; ///< per target vertex, the best match on the source
  std::vector<double> Certainty;            ///< per target vertex: 1 on matched branches, else less
  /// Target vertices x source pieces: how likely the vertex belongs to the piece. Rows sum to 1.
  Eigen::MatrixXd Shares;
  bool IsWholeAlignment = true; ///< the skeletons were of no use
};

/// Each target vertex is carried by the transformation of its node (SkeletonMap::Place), smoothed
/// over the surface so that joints blend; there the nearest triangles of the source with a like
/// normal and a near place on the skeleton are looked up. Displacements to what was found, smoothed,
/// then correct the positions and the search is repeated, a few times: proportions that the skeleton
/// does not show (the depth of a chest) are taken up by that. The shares of the pieces are at last
/// smoothed by `blend`, as the map is no more exact than that.
///
/// Pieces with `isTransferred` false are skipped: their place goes to their neighbours.
/// The target is also aligned as a whole (AlignWhole). That is used instead if no chain is matched,
/// or if the skeletons bring the surfaces together no better: then they are of no use, as for a bust
/// or a machine part.
GuidedMap BuildGuidedMap(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<SkeletonMap::Place>& places, bool anyMatched, const SegmentPieces& pieces,
  const std::vector<bool>& isTransferred, const MeshSmoother& blend, const Progress& progress);
}

#endif
