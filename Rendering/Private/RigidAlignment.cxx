// SPDX-License-Identifier: BSD-3-Clause
#include "RigidAlignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace marrow
{
Eigen::Matrix3d RotationTo(const LabelCentroids& reference, const LabelCentroids& mesh)
{
  Eigen::Matrix3Xd here(3, mesh.size());
  Eigen::Matrix3Xd there(3, mesh.size());
  Eigen::Index shared = 0;
  for (const auto& [label, centroid] : mesh)
  {
    const auto found = reference.find(label);
    if (found != reference.end())
    {
      here.col(shared) = centroid;
      there.col(shared) = found->second;
      ++shared;
    }
  }
  if (shared < 3)
  {
    return Eigen::Matrix3d::Identity();
  }
  const bool withScaling = false;
  return Eigen::umeyama(here.leftCols(shared), there.leftCols(shared), withScaling)
    .topLeftCorner<3, 3>();
}

Eigen::Vector3d BroadSide(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& up)
{
  const Eigen::Vector3d x = up.unitOrthogonal();
  const Eigen::Vector3d y = up.normalized().cross(x);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& point : points)
  {
    mean += Eigen::Vector2d(point.dot(x), point.dot(y)) / static_cast<double>(points.size());
  }
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& point : points)
  {
    const Eigen::Vector2d offset = Eigen::Vector2d(point.dot(x), point.dot(y)) - mean;
    covariance += offset * offset.transpose();
  }
  const Eigen::Vector2d least =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvectors().col(0);
  const Eigen::Vector3d direction = least[0] * x + least[1] * y;
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0.0 ? Eigen::Vector3d(-direction) : direction;
}
}
