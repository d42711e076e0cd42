// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BranchAssignment_h
#define marrow_BranchAssignment_h

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// The branches of a matched junction pair that wait for a partner.
struct BranchSets
{
  std::vector<Eigen::Vector3d> Source; ///< unit branch vectors
  std::vector<Eigen::Vector3d> Target;
  /// Vectors of the branches that are matched already: they take part in the rotation.
  std::vector<Eigen::Vector3d> KnownSource;
  std::vector<Eigen::Vector3d> KnownTarget;
  /// How unlike two branches are, ≥ 0; source × target.
  Eigen::MatrixXd Unlikeness;
};

/// One way to match them: all of the fewer have a partner.
struct BranchAssignment
{
  std::vector<int> TargetOfSource; ///< -1 for none
  double SpatialCost = 0.0;        ///< C_spatial (correspondence paper, equation 5)
  double Unlikeness = 0.0;         ///< sum over the pairs
};

/// The rotation (never a reflection) that takes target vectors closest to source vectors, by shape
/// matching. False if the vectors say clearly that only a reflection would.
bool BestRotation(const std::vector<Eigen::Vector3d>& source,
  const std::vector<Eigen::Vector3d>& target, Eigen::Matrix3d& rotation);

/// C_spatial (correspondence paper, equation 5) of vectors matched in order, under BestRotation.
double SpatialCost(
  const std::vector<Eigen::Vector3d>& source, const std::vector<Eigen::Vector3d>& target);

/// The assignments that need no reflection. All of them where there are few (up to 720); else, for
/// every pair of source branches on every pair of target branches, the best assignment under the
/// rotation these two suggest, which is polynomial in the number of branches and still holds the
/// best one.
std::vector<BranchAssignment> FindAssignments(const BranchSets& sets);
}

#endif
