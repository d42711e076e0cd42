// SPDX-License-Identifier: BSD-3-Clause
#include "WindingNumber.h"

#include "Constants.h"

#include <Eigen/Geometry>

#include <cmath>

namespace marrow
{
double WindingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point)
{
  double solidAngle = 0.0;
  for (const auto& triangle : mesh.Triangles)
  {
    const Eigen::Vector3d a = mesh.Points[triangle[0]] - point;
    const Eigen::Vector3d b = mesh.Points[triangle[1]] - point;
    const Eigen::Vector3d c = mesh.Points[triangle[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    solidAngle += 2.0 * std::atan2(numerator, denominator);
  }
  return solidAngle / (4.0 * Pi);
}
}
