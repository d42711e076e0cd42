// SPDX-License-Identifier: BSD-3-Clause
#include "WholeAlignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace marrow
{
namespace
{
struct Axes
{
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d Directions = Eigen::Matrix3d::Identity(); ///< columns, a right-handed frame
  double Size = 0.0;
};

Axes PrincipalAxes(const TriangleMesh& mesh)
{
  Axes axes;
  const std::vector<double> areas = mesh.VertexAreas();
  double total = 0.0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    axes.Center += areas[v] * mesh.Points[v];
    total += areas[v];
  }
  axes.Center /= std::max(total, 1e-300);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const Eigen::Vector3d d = mesh.Points[v] - axes.Center;
    covariance += areas[v] * d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  axes.Directions = solver.eigenvectors();
  if (axes.Directions.determinant() < 0.0)
  {
    axes.Directions.col(0) *= -1.0;
  }
  axes.Size = std::sqrt(covariance.trace() / std::max(total, 1e-300));
  return axes;
}

/// About `count` points spread over the vertex numbers.
std::vector<Eigen::Vector3d> SomePoints(const TriangleMesh& mesh, int count)
{
  std::vector<Eigen::Vector3d> points;
  const int step = std::max(1, mesh.NumberOfVertices() / count);
  for (int v = 0; v < mesh.NumberOfVertices(); v += step)
  {
    points.push_back(mesh.Points[v]);
  }
  return points;
}
}

Eigen::Matrix<double, 3, 4> AlignWhole(const TriangleMesh& source, const TriangleMesh& target)
{
  const Axes to = PrincipalAxes(source);
  const Axes from = PrincipalAxes(target);
  const double scale = from.Size > 0.0 ? to.Size / from.Size : 1.0;
  const std::vector<Eigen::Vector3d> targets = SomePoints(target, 400);
  const std::vector<Eigen::Vector3d> sources = SomePoints(source, 1600);
  Eigen::Matrix<double, 3, 4> best = Eigen::Matrix<double, 3, 4>::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& signs : { Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
         Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1) })
  {
    Eigen::Matrix<double, 3, 4> transform;
    transform.leftCols<3>() =
      scale * to.Directions * signs.asDiagonal() * from.Directions.transpose();
    transform.col(3) = to.Center - transform.leftCols<3>() * from.Center;
    double sum = 0.0;
    for (const Eigen::Vector3d& point : targets)
    {
      const Eigen::Vector3d moved = transform.leftCols<3>() * point + transform.col(3);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector3d& candidate : sources)
      {
        nearest = std::min(nearest, (candidate - moved).squaredNorm());
      }
      sum += nearest;
    }
    if (sum < least)
    {
      least = sum;
      best = transform;
    }
  }
  return best;
}
}
