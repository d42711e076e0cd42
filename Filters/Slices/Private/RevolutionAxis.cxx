// SPDX-License-Identifier: BSD-3-Clause
#include "RevolutionAxis.h"

#include <Eigen/Cholesky>
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
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The sine beyond which a triangle counts as not of the surface of revolution.
constexpr double Tolerance = 0.2;
/// Enough that the weights change no more.
constexpr int NumberOfRounds = 5;
/// About so many triangles say enough.
constexpr int NumberOfSamples = 5000;

/// A triangle seen from the centroid, with the root mean square distance as the unit.
struct Sample
{
  Eigen::Vector3d Position;
  Eigen::Vector3d Normal;
  double Area = 0.0; ///< of the whole
};

/// The axis of a rotation with velocity Direction × (p − Point).
struct Axis
{
  Eigen::Vector3d Direction;
  Eigen::Vector3d Point;
};

/// The axes for which the speed along the normals is stationary, the least first.
std::vector<Axis> SolveAxes(const std::vector<Sample>& samples, const std::vector<double>& weights)
{
  Matrix6d matrix = Matrix6d::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    Vector6d row;
    row << samples[i].Position.cross(samples[i].Normal), samples[i].Normal;
    matrix += weights[i] * row * row.transpose();
  }
  constexpr double least =
    1e-9; // A flat mesh has normals of one direction: there is no shift along it.
  const Eigen::Matrix3d shift =
    matrix.bottomRightCorner<3, 3>() + least * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d shiftOfTurn = shift.ldlt().solve(matrix.bottomLeftCorner<3, 3>());
  const Eigen::Matrix3d turn =
    matrix.topLeftCorner<3, 3>() - matrix.topRightCorner<3, 3>() * shiftOfTurn;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(0.5 * (turn + turn.transpose()));
  std::vector<Axis> axes;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d direction = solver.eigenvectors().col(k);
    axes.push_back({ direction, direction.cross(-shiftOfTurn * direction) });
  }
  return axes;
}

double SineOf(const Sample& sample, const Axis& axis)
{
  const Eigen::Vector3d velocity = axis.Direction.cross(sample.Position - axis.Point);
  const double speed = velocity.norm();
  return speed > 0.0 ? std::abs(sample.Normal.dot(velocity)) / speed : 0.0;
}

Axis Nearest(const std::vector<Axis>& axes, const Eigen::Vector3d& direction)
{
  return *std::max_element(axes.begin(), axes.end(),
    [&](const Axis& a, const Axis& b)
    { return std::abs(a.Direction.dot(direction)) < std::abs(b.Direction.dot(direction)); });
}
}

RevolutionAxis FindRevolutionAxis(const TriangleMesh& mesh)
{
  std::vector<Sample> samples;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double total = 0.0;
  const int step = std::max(1, mesh.NumberOfTriangles() / NumberOfSamples);
  for (int t = 0; t < mesh.NumberOfTriangles(); t += step)
  {
    const Eigen::Vector3d vector = mesh.AreaVector(t);
    const double area = 0.5 * vector.norm();
    if (area > 0.0)
    {
      samples.push_back({ mesh.Centroid(t), vector.normalized(), area });
      center += area * samples.back().Position;
      total += area;
    }
  }
  RevolutionAxis best;
  if (samples.empty())
  {
    return best;
  }
  center /= total;
  double squared = 0.0;
  for (Sample& sample : samples)
  {
    sample.Position -= center;
    sample.Area /= total;
    squared += sample.Area * sample.Position.squaredNorm();
  }
  const double size = std::sqrt(squared);
  std::vector<double> areas;
  for (Sample& sample : samples)
  {
    sample.Position /= std::max(size, 1e-300);
    areas.push_back(sample.Area);
  }

  double least = std::numeric_limits<double>::infinity();
  for (const Axis& start : SolveAxes(samples, areas))
  {
    Axis axis = start;
    for (int round = 0; round < NumberOfRounds; ++round)
    {
      std::vector<double> weights;
      for (const Sample& sample : samples)
      {
        const double excess = SineOf(sample, axis) / Tolerance;
        weights.push_back(sample.Area / (1.0 + excess * excess));
      }
      axis = Nearest(SolveAxes(samples, weights), axis.Direction);
    }
    // How far the surface leaves itself.
    double deviation = 0.0;
    for (const Sample& sample : samples)
    {
      deviation += sample.Area * SineOf(sample, axis);
    }
    if (deviation < least)
    {
      least = deviation;
      best.Direction = axis.Direction;
      best.Point = center + size * axis.Point;
    }
  }
  return best;
}
}
