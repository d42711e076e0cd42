// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Cotangent_h
#define marrow_Cotangent_h

#include <Eigen/Geometry>

#include <algorithm>

namespace marrow
{
/// The cotangent of the angle at `apex` between two points, at most 20; 0 where they have no area with it.
inline double BoundedCotangent(
  const Eigen::Vector3d& apex, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  constexpr double most = 20.0; // 3 degrees: slivers would couple their vertices rigidly
  const Eigen::Vector3d u = a - apex;
  const Eigen::Vector3d v = b - apex;
  const double twiceArea = u.cross(v).norm();
  return twiceArea > 0.0 ? std::min(u.dot(v) / twiceArea, most) : 0.0;
}
}

#endif
