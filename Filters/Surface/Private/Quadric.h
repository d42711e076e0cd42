// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Quadric_h
#define marrow_Quadric_h

#include <Eigen/Core>

#include <algorithm>

namespace marrow
{
/// A weighted sum of squared distances to planes, as a function of the point (Garland and Heckbert
/// 1997).
class Quadric
{
public:
  Quadric() = default;
  /// Of one plane, through `point` with a unit normal.
  Quadric(const Eigen::Vector3d& normal, const Eigen::Vector3d& point, double weight)
  {
    const double offset = -normal.dot(point);
    this->Matrix << normal[0] * normal[0], normal[0] * normal[1], normal[0] * normal[2],
      normal[1] * normal[1], normal[1] * normal[2], normal[2] * normal[2];
    this->Matrix *= weight;
    this->Linear = weight * offset * normal;
    this->Constant = weight * offset * offset;
  }

  Quadric& operator+=(const Quadric& other)
  {
    this->Matrix += other.Matrix;
    this->Linear += other.Linear;
    this->Constant += other.Constant;
    return *this;
  }

  double At(const Eigen::Vector3d& p) const
  {
    const auto& m = this->Matrix;
    const double squares = m[0] * p[0] * p[0] + m[3] * p[1] * p[1] + m[5] * p[2] * p[2];
    const double mixed = m[1] * p[0] * p[1] + m[2] * p[0] * p[2] + m[4] * p[1] * p[2];
    // Rounding may take a sum of squares below 0.
    return std::max(0.0, squares + 2.0 * mixed + 2.0 * this->Linear.dot(p) + this->Constant);
  }

private:
  Eigen::Matrix<double, 6, 1> Matrix = Eigen::Matrix<double, 6, 1>::Zero(); ///< upper half, by rows
  Eigen::Vector3d Linear = Eigen::Vector3d::Zero();
  double Constant = 0.0;
};
}

#endif
