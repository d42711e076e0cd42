// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_RigidAlignment_h
#define marrow_RigidAlignment_h

#include <Eigen/Core>

#include <map>
#include <vector>

namespace marrow
{
/// Per label of a mesh the centroid of its part of the surface.
using LabelCentroids = std::map<int, Eigen::Vector3d>;

/// The rotation that turns a mesh so that its parts stand where the parts of the same labels stand
/// in `reference`: least squares over the centroids, each set taken from its own mean, never a
/// reflection. The identity when fewer than three labels are shared: they fix no rotation.
Eigen::Matrix3d RotationTo(const LabelCentroids& reference, const LabelCentroids& mesh);

/// The direction perpendicular to `up` along which the points spread least: from there an animal is
/// seen from its side, a chair or a figure from its broad side. The sign is chosen so that the
/// largest component is positive, as points alone do not tell left from right.
Eigen::Vector3d BroadSide(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& up);
}

#endif
