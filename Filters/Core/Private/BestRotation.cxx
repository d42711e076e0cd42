// SPDX-License-Identifier: BSD-3-Clause
#include "BestRotation.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace marrow
{
Eigen::Matrix3d BestRotation(const Eigen::Matrix3d& covariance)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d correction = Eigen::Matrix3d::Identity();
  correction(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * correction * svd.matrixV().transpose();
}
}
