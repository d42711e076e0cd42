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
/// Samples by which a similarity of seven parameters is found; time grows with the product.
constexpr int NumberOfFew = 150;
constexpr int NumberOfMany = 500;

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

/// Points of a surface, a column each: the position, and the normal in a length that makes turned normals as far
/// apart as places.
using Samples = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// About `count`, spread over the vertex numbers; a normal that is turned right round is as far as `turn`.
Samples SomeOf(const TriangleMesh& mesh, int count, double turn)
{
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  const int step = std::max(1, mesh.NumberOfVertices() / count);
  Samples samples(6, (mesh.NumberOfVertices() + step - 1) / step);
  for (Eigen::Index i = 0; i < samples.cols(); ++i)
  {
    const auto v = static_cast<std::size_t>(i * step);
    samples.col(i) << mesh.Points[v], 0.5 * turn * normals[v];
  }
  return samples;
}

Samples Moved(const Samples& samples, const Eigen::Matrix<double, 3, 4>& transform)
{
  const Eigen::Matrix3d linear = transform.leftCols<3>();
  Samples moved(6, samples.cols());
  moved.topRows<3>() = (linear * samples.topRows<3>()).colwise() + transform.col(3);
  moved.bottomRows<3>() = linear / linear.col(0).norm() * samples.bottomRows<3>();
  return moved;
}

/// The one of `candidates` that is nearest to each sample, and the mean of the squared distances.
double FindNearest(
  const Samples& samples, const Samples& candidates, std::vector<Eigen::Index>& nearest)
{
  const Eigen::VectorXd squares = candidates.colwise().squaredNorm();
  const Eigen::MatrixXd products = candidates.transpose() * samples;
  double sum = samples.squaredNorm();
  nearest.resize(samples.cols());
  for (Eigen::Index i = 0; i < samples.cols(); ++i)
  {
    sum += (squares - 2.0 * products.col(i)).minCoeff(&nearest[i]);
  }
  return sum / static_cast<double>(samples.cols());
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
  const double scale = from.Size > 0.0 && to.Size > 0.0 ? to.Size / from.Size : 1.0;
  // Each of the few of one surface looks for the nearest of the many of the other.
  const double turn = scale * from.Size;
  const Samples fewOfTarget = SomeOf(target, NumberOfFew, turn);
  const Samples manyOfTarget = SomeOf(target, NumberOfMany, turn);
  const Samples fewOfSource = SomeOf(source, NumberOfFew, turn);
  const Samples manyOfSource = SomeOf(source, NumberOfMany, turn);
  std::vector<std::pair<double, Eigen::Matrix<double, 3, 4>>> starts;
  Samples fewMoved;
  Samples manyMoved;
  std::vector<Eigen::Index> ofTarget;
  std::vector<Eigen::Index> ofSource;
  const auto misfit = [&](const Eigen::Matrix<double, 3, 4>& transform)
  {
    double ofHints = 0.0;
    for (const SurfaceHint& hint : hints)
    {
      const Eigen::Vector3d moved =
        transform.leftCols<3>() * target.Points[hint.TargetVertex] + transform.col(3);
      ofHints += hint.IsForbidden ? 0.0 : (moved - source.Points[hint.SourceVertex]).squaredNorm();
    }
    fewMoved = Moved(fewOfTarget, transform);
    manyMoved = Moved(manyOfTarget, transform);
    return 0.5 * FindNearest(fewMoved, manyOfSource, ofTarget) +
      0.5 * FindNearest(fewOfSource, manyMoved, ofSource) + ofHints;
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
  constexpr std::size_t numberOfStarts = 8;
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
      Eigen::Matrix3Xd moving(3, fewMoved.cols() + fewOfSource.cols());
      Eigen::Matrix3Xd fixed(3, moving.cols());
      moving << fewMoved.topRows<3>(), manyMoved(Eigen::seqN(0, 3), ofSource);
      fixed << manyOfSource(Eigen::seqN(0, 3), ofTarget), fewOfSource.topRows<3>();
      // The size stays: closest points alone would shrink the one into the other.
      const Eigen::Matrix4d step = Eigen::umeyama(moving, fixed, false);
      transform = step.topRows<3>() *
        (Eigen::Matrix4d() << transform, Eigen::RowVector4d(0, 0, 0, 1)).finished();
    }
  }
  return best;
}
}
