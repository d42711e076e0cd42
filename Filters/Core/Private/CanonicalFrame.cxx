// SPDX-License-Identifier: BSD-3-Clause
#include "CanonicalFrame.h"

#include "BinaryScale.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace marrow
{
namespace
{
/// A sixteenth of what single precision resolves of a unit: files in single precision lose nothing, and
/// what double precision loses by a rotation is a million times smaller.
constexpr double GridSpacing = 1.0 / (1 << 28);

/// Of the centroids, over the reach of the corners. What rounding leaves where all centroids are one is
/// far below.
constexpr double LeastSpread = 1e-6;

// Sums of many values: in more than double precision, so that their order plays no part.
using Sum = long double;

/// Puts the corner with the least number first and keeps the orientation.
std::array<int, 3> LeastCornerFirst(std::array<int, 3> corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// The sum of the positions of the corners beside each vertex: tells vertices at one place apart, as
/// where separate sheets touch.
std::vector<Eigen::Vector3d> NeighborSums(const TriangleMesh& mesh)
{
  std::vector<Eigen::Vector3d> sums(mesh.Points.size(), Eigen::Vector3d::Zero());
  for (const auto& corners : mesh.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      // Exact on the grid, and so the same in any order.
      sums[corners[k]] += mesh.Points[corners[(k + 1) % 3]] + mesh.Points[corners[(k + 2) % 3]];
    }
  }
  return sums;
}

/// The frame of a mesh whose powers of coordinates stay in the range of doubles.
CanonicalFrame FrameOf(const TriangleMesh& mesh)
{
  std::vector<Eigen::Vector3d> centroids(mesh.Triangles.size());
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(3 * mesh.Triangles.size());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    centroids[t] = mesh.Centroid(t);
    for (const int corner : mesh.Triangles[t])
    {
      corners.push_back(mesh.Points[corner]);
    }
  }
  const CanonicalFrame frame(centroids, mesh.TriangleAreas());
  const double reach = std::accumulate(corners.begin(), corners.end(), 0.0,
    [&](double most, const Eigen::Vector3d& point)
    { return std::max(most, (point - frame.FromFrame(Eigen::Vector3d::Zero())).norm()); });
  // One triangle, two that lie on each other, or none with an area: their centroids say nothing of the size.
  return frame.HasSpread() && frame.LengthFromFrame(1.0) > LeastSpread * reach
    ? frame
    : CanonicalFrame(corners, std::vector<double>(corners.size(), 1.0));
}
}

CanonicalFrame::CanonicalFrame(
  const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights)
{
  Sum total = 0;
  std::array<Sum, 3> center{};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    total += weights[i];
    for (int k = 0; k < 3; ++k)
    {
      center[k] += static_cast<Sum>(weights[i]) * points[i][k];
    }
  }
  if (!(total > 0))
  {
    return;
  }
  for (int k = 0; k < 3; ++k)
  {
    this->Center[k] = static_cast<double>(center[k] / total);
  }

  std::array<std::array<Sum, 3>, 3> second{};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3d p = points[i] - this->Center;
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0; c <= r; ++c)
      {
        second[r][c] += static_cast<Sum>(weights[i]) * p[r] * p[c];
      }
    }
  }
  Eigen::Matrix3d covariance;
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c <= r; ++c)
    {
      covariance(r, c) = covariance(c, r) = static_cast<double>(second[r][c] / total);
    }
  }
  if (!(covariance.trace() > 0.0) || !std::isfinite(covariance.trace()))
  {
    return;
  }
  this->Spreads = true;
  this->Unit = std::sqrt(covariance.trace());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  // The longest axis first.
  this->Axes = solver.eigenvectors().rowwise().reverse().transpose();

  std::array<Sum, 3> third{};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3d p = this->Axes * (points[i] - this->Center) / this->Unit;
    for (int k = 0; k < 3; ++k)
    {
      third[k] += static_cast<Sum>(weights[i]) * p[k] * p[k] * p[k];
    }
  }
  int least = 0;
  for (int k = 0; k < 3; ++k)
  {
    if (third[k] < 0)
    {
      this->Axes.row(k) = -this->Axes.row(k);
    }
    least = std::abs(third[k]) < std::abs(third[least]) ? k : least;
  }
  if (this->Axes.determinant() < 0.0)
  {
    this->Axes.row(least) = -this->Axes.row(least);
  }
}

void CanonicalFrame::Scale(int exponent)
{
  marrow::Scale(this->Center, exponent);
  this->Unit = std::ldexp(this->Unit, exponent);
}

double CanonicalFrame::ToGrid(double value)
{
  // The sum turns -0 into 0, which some functions tell apart.
  return std::nearbyint(value / GridSpacing) * GridSpacing + 0.0;
}

Eigen::Vector3d CanonicalFrame::ToGrid(const Eigen::Vector3d& value)
{
  return { ToGrid(value[0]), ToGrid(value[1]), ToGrid(value[2]) };
}

Eigen::Vector3d CanonicalFrame::ToFrame(const Eigen::Vector3d& point) const
{
  return ToGrid(Eigen::Vector3d(this->Axes * (point - this->Center) / this->Unit));
}

Eigen::Vector3d CanonicalFrame::FromFrame(const Eigen::Vector3d& point) const
{
  return this->Axes.transpose() * point * this->Unit + this->Center;
}

double CanonicalFrame::LengthToFrame(double length) const
{
  return ToGrid(length / this->Unit);
}

CanonicalMesh ToCanonicalMesh(const TriangleMesh& mesh)
{
  std::vector<int> used(mesh.Points.size());
  std::iota(used.begin(), used.end(), 0);
  const int exponent = ScaleExponent(mesh.Points, used);
  TriangleMesh scaled;
  scaled.Points = mesh.Points;
  scaled.Triangles = mesh.Triangles;
  Scale(scaled.Points, -exponent);
  CanonicalMesh result;
  result.Frame = FrameOf(scaled);
  result.Frame.Scale(exponent);

  TriangleMesh moved;
  moved.Triangles = mesh.Triangles;
  moved.Points.resize(mesh.Points.size());
  std::transform(mesh.Points.begin(), mesh.Points.end(), moved.Points.begin(),
    [&](const Eigen::Vector3d& point) { return result.Frame.ToFrame(point); });

  const std::vector<Eigen::Vector3d> sums = NeighborSums(moved);
  result.OriginalVertex.resize(mesh.Points.size());
  std::iota(result.OriginalVertex.begin(), result.OriginalVertex.end(), 0);
  const auto key = [&](int v)
  {
    const Eigen::Vector3d& p = moved.Points[v];
    const Eigen::Vector3d& s = sums[v];
    return std::tuple(p[0], p[1], p[2], s[0], s[1], s[2], v);
  };
  std::sort(result.OriginalVertex.begin(), result.OriginalVertex.end(),
    [&](int a, int b) { return key(a) < key(b); });
  std::vector<int> rank(mesh.Points.size());
  result.Mesh.Points.resize(mesh.Points.size());
  for (std::size_t i = 0; i < rank.size(); ++i)
  {
    rank[result.OriginalVertex[i]] = static_cast<int>(i);
    result.Mesh.Points[i] = moved.Points[result.OriginalVertex[i]];
  }

  for (auto& corners : moved.Triangles)
  {
    corners = LeastCornerFirst({ rank[corners[0]], rank[corners[1]], rank[corners[2]] });
  }
  result.OriginalTriangle.resize(mesh.Triangles.size());
  std::iota(result.OriginalTriangle.begin(), result.OriginalTriangle.end(), 0);
  std::sort(result.OriginalTriangle.begin(), result.OriginalTriangle.end(),
    [&](int a, int b)
    { return std::tie(moved.Triangles[a], a) < std::tie(moved.Triangles[b], b); });
  result.Mesh.Triangles.reserve(mesh.Triangles.size());
  for (int t : result.OriginalTriangle)
  {
    result.Mesh.Triangles.push_back(moved.Triangles[t]);
  }
  result.Mesh.BuildConnectivity();
  return result;
}
}
