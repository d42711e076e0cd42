// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_EnclosedBranch_h
#define marrow_EnclosedBranch_h

#include "AnalyzedMesh.h"
#include "MatchedSkeletons.h"
#include "SegmentLoops.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// The plane of a loop, by principal component analysis of its points weighted by length.
struct FittingPlane
{
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  Eigen::Vector3d Normal = Eigen::Vector3d::UnitX();
  double Radius = 0.0; ///< mean distance of the loop from the centre

  double Offset(const Eigen::Vector3d& point) const
  {
    return (point - this->Center).dot(this->Normal);
  }
};
FittingPlane FitPlane(const TriangleMesh& mesh, const std::vector<int>& loopVertices);

/// Marks the triangles to the left of the loop by 1 and those to the right by 0; false if the loop
/// does not separate the surface.
bool SidesOfLoop(
  const TriangleMesh& mesh, const std::vector<int>& halfEdges, std::vector<char>& sides);

/// What a loop encloses.
struct Enclosure
{
  int NumberOfBranches = 0; ///< how many branches of the skeleton pass through the loop
  int Branch = -1;          ///< the one, if it is exactly one
  double ArcLength = 0.0;   ///< where on that branch, from its front
};

/// T:4.1 says that a loop encloses the branch that crosses its fitting plane inside it. Bent limbs
/// and crooked loops have planes that cross other branches too, and none at all near junctions.
/// So the surface decides first: the loop cuts it in two, and a branch is enclosed where φ of its
/// nodes changes from one side to the other. A junction whose φ is cut by the loop goes to the side
/// that leaves the fewest branches cut. The plane then places the point on the branch. A loop that
/// does not cut the surface in two (on a handle) is decided by the plane alone.
Enclosure FindEnclosure(const AnalyzedMesh& mesh, const std::vector<int>& halfEdges);
}

#endif
