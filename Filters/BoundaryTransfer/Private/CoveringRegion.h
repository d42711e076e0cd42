// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CoveringRegion_h
#define marrow_CoveringRegion_h

#include "EnclosedBranch.h"
#include "MeshPaths.h"
#include "TriangleMesh.h"

#include <optional>
#include <vector>

namespace marrow
{
/// An annulus of triangles round a branch (T:4.2).
struct CoveringRegion
{
  std::vector<int> Triangles; ///< ascending
  /// The vertices of the two rims, in order, with the region on the left; the first rim is the one
  /// further against the plane's normal.
  std::vector<int> Rims[2];
};

/// One vertex of the surface for every ray from `center` to one of `rayEnds`: a ray that is too
/// short is prolonged up to twice its length, a longer one clamped where it leaves the surface; where
/// it does not meet the surface, the vertex nearest to its end.
std::vector<int> SeedsOfRays(const TriangleMesh& mesh, const Eigen::Vector3d& center,
  const std::vector<Eigen::Vector3d>& rayEnds);

/// Covers what a plane cuts of a limb: the seeds are connected by shortest paths that keep to the
/// plane, and the ring that they make is grown to all that is connected with it and within
/// `halfWidth` of the plane, and to the 1-rings of `mustCover`. Holes are filled. If that is no
/// annulus (the plane cuts other parts as well), narrower bands are tried; nothing is returned if
/// none is one.
std::optional<CoveringRegion> BuildCoveringRegion(const TriangleMesh& mesh, PathFinder& paths,
  const FittingPlane& plane, const std::vector<int>& seeds, double halfWidth,
  const std::vector<int>& mustCover);
}

#endif
