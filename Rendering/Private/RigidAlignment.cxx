// SPDX-License-Identifier: BSD-3-Clause
#include "RigidAlignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace marrow
{
Eigen::Matrix3d RotationTo(const LabelCentroids& reference, const LabelCentroids& mesh)
{
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> pairs;
  Eigen::Vector3d referenceMean = Eigen::Vector3d::Zero();
  Eigen::Vector3d meshMean = Eigen::Vector3d::Zero();
  for (const auto& [label, centroid] : mesh)
  {
    const auto found = reference.find(label);
    if (found != reference.end())
    {
      pairs.emplace_back(found->second, centroid);
      referenceMean += found->second;
      meshMean += centroid;
    }
  }
  if (pairs.size() < 3)
  {
    return Eigen::Matrix3d::Identity();
  }
  referenceMean /= static_cast<double>(pairs.size());
  meshMean /= static_cast<double>(pairs.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& [there, here] : pairs)
  {
    covariance += (there - referenceMean) * (here - meshMean).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
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
