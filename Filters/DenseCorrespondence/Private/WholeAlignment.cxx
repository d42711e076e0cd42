// SPDX-License-Identifier: BSD-3-Clause
#include "WholeAlignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace marrow
{
namespace
{
/// Points by which a similarity of seven parameters is found; time grows with the product.
constexpr int NumberOfTargets = 300;
constexpr int NumberOfSources = 1000;

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

/// The nearest of `candidates` to every moved point, and the sum of squared distances.
double FindNearest(const std::vector<Eigen::Vector3d>& points,
  const Eigen::Matrix<double, 3, 4>& transform, const std::vector<Eigen::Vector3d>& candidates,
  std::vector<int>& nearest)
{
  double sum = 0.0;
  nearest.assign(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3d moved = transform.leftCols<3>() * points[i] + transform.col(3);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < candidates.size(); ++c)
    {
      const double distance = (candidates[c] - moved).squaredNorm();
      if (distance < least)
      {
        least = distance;
        nearest[i] = static_cast<int>(c);
      }
    }
    sum += least;
  }
  return sum;
}

/// All ways to lay one right-handed frame of axes on another.
std::vector<Eigen::Matrix3d> FrameRotations()
{
  std::vector<Eigen::Matrix3d> rotations;
  std::array<int, 3> order = { 0, 1, 2 };
  do
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
      for (int k = 0; k < 3; ++k)
      {
        rotation(k, order[k]) = (signs >> k) & 1 ? -1.0 : 1.0;
      }
      if (rotation.determinant() > 0.0)
      {
        rotations.push_back(rotation);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}
}

Eigen::Matrix<double, 3, 4> AlignWhole(
  const TriangleMesh& source, const TriangleMesh& target, const std::vector<SurfaceHint>& hints)
{
  const Axes to = PrincipalAxes(source);
  const Axes from = PrincipalAxes(target);
  const double scale = from.Size > 0.0 ? to.Size / from.Size : 1.0;
  const std::vector<Eigen::Vector3d> targets = SomePoints(target, NumberOfTargets);
  const std::vector<Eigen::Vector3d> sources = SomePoints(source, NumberOfSources);
  std::vector<std::pair<double, Eigen::Matrix<double, 3, 4>>> starts;
  std::vector<int> nearest;
  const auto misfit = [&](const Eigen::Matrix<double, 3, 4>& transform)
  {
    double ofHints = 0.0;
    for (const SurfaceHint& hint : hints)
    {
      const Eigen::Vector3d moved =
        transform.leftCols<3>() * target.Points[hint.TargetVertex] + transform.col(3);
      ofHints += hint.IsForbidden ? 0.0 : (moved - source.Points[hint.SourceVertex]).squaredNorm();
    }
    return FindNearest(targets, transform, sources, nearest) +
      static_cast<double>(targets.size()) * ofHints;
  };
  for (const Eigen::Matrix3d& rotation : FrameRotations())
  {
    Eigen::Matrix<double, 3, 4> transform;
    transform.leftCols<3>() = scale * to.Directions * rotation * from.Directions.transpose();
    transform.col(3) = to.Center - transform.leftCols<3>() * from.Center;
    starts.emplace_back(misfit(transform), transform);
  }
  std::stable_sort(
    starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  // Closest points improve the best few.
  constexpr std::size_t numberOfStarts = 4;
  constexpr int numberOfRounds = 10;
  Eigen::Matrix<double, 3, 4> best = starts.front().second;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < numberOfStarts; ++s)
  {
    Eigen::Matrix<double, 3, 4> transform = starts[s].second;
    for (int round = 0; round <= numberOfRounds; ++round)
    {
      const double sum = misfit(transform);
      if (sum < least)
      {
        least = sum;
        best = transform;
      }
      Eigen::Matrix3Xd moving(3, targets.size());
      Eigen::Matrix3Xd fixed(3, targets.size());
      for (std::size_t i = 0; i < targets.size(); ++i)
      {
        moving.col(static_cast<Eigen::Index>(i)) =
          transform.leftCols<3>() * targets[i] + transform.col(3);
        fixed.col(static_cast<Eigen::Index>(i)) = sources[nearest[i]];
      }
      // The size stays: closest points alone would shrink the one into the other.
      const Eigen::Matrix4d step = Eigen::umeyama(moving, fixed, false);
      transform = step.topRows<3>() *
        (Eigen::Matrix4d() << transform, Eigen::RowVector4d(0, 0, 0, 1)).finished();
    }
  }
  return best;
}
}
