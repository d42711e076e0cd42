// SPDX-License-Identifier: BSD-3-Clause
#include "EdgePrices.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace marrow
{
namespace
{
double EdgeLength(const TriangleMesh& mesh, int halfEdge)
{
  return (mesh.Points[mesh.From(halfEdge)] - mesh.Points[mesh.To(halfEdge)]).norm();
}
}

std::vector<double> EdgeConcavity(const TriangleMesh& mesh, const MeshSmoother& smoother)
{
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  Eigen::MatrixXd rows(mesh.NumberOfVertices(), 3);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    rows.row(v) = normals[v].transpose();
  }
  rows = smoother.Smooth(rows);
  const auto normalOf = [&](int triangle) -> Eigen::Vector3d
  {
    const auto& [a, b, c] = mesh.Triangles[triangle];
    return (rows.row(a) + rows.row(b) + rows.row(c)).transpose().stableNormalized();
  };
  std::vector<double> concavity(mesh.Opposite.size(), 0.0);
  for (int h = 0; h < static_cast<int>(concavity.size()); ++h)
  {
    if (mesh.Opposite[h] <= h)
    {
      continue;
    }
    const int a = TriangleMesh::TriangleOf(h);
    const int b = TriangleMesh::TriangleOf(mesh.Opposite[h]);
    const Eigen::Vector3d step = mesh.Centroid(b) - mesh.Centroid(a);
    const double squared = step.squaredNorm();
    const double curvature = squared > 0.0 ? (normalOf(b) - normalOf(a)).dot(step) / squared : 0.0;
    concavity[h] = std::clamp(-curvature * smoother.GetWidth(), 0.0, 1.0);
  }
  return concavity;
}

double ConcavityPreference(const TriangleMesh& mesh, const std::vector<double>& concavity,
  const std::vector<int>& segmentOfTriangle)
{
  std::vector<std::pair<double, double>> edges; // length, concavity
  double boundaryLength = 0.0;
  double boundarySum = 0.0;
  for (int h = 0; h < static_cast<int>(concavity.size()); ++h)
  {
    const int opposite = mesh.Opposite[h];
    if (opposite <= h)
    {
      continue;
    }
    const double length = EdgeLength(mesh, h);
    edges.emplace_back(length, concavity[h]);
    if (segmentOfTriangle[TriangleMesh::TriangleOf(h)] !=
      segmentOfTriangle[TriangleMesh::TriangleOf(opposite)])
    {
      boundaryLength += length;
      boundarySum += length * concavity[h];
    }
  }
  // The mean concavity of edges so drawn grows with the preference.
  const auto fallsShort = [&](double preference)
  {
    double sum = 0.0;
    double total = 0.0;
    for (const auto& [length, value] : edges)
    {
      const double weight = length * std::exp(preference * value);
      sum += weight * value;
      total += weight;
    }
    return sum * boundaryLength < boundarySum * total;
  };
  double low = 0.0;
  double high = 20.0;          // of a preference: then a flat edge costs all but nothing less
  constexpr int halvings = 12; // to 0.005
  for (int i = 0; i < halvings; ++i)
  {
    const double middle = 0.5 * (low + high);
    (fallsShort(middle) ? low : high) = middle;
  }
  return low;
}

double PreferenceOf(
  const TriangleMesh& mesh, const std::vector<int>& segmentOfTriangle, double width)
{
  const MeshSmoother blend(mesh, width * mesh.BoundingBoxDiagonal());
  return ConcavityPreference(mesh, EdgeConcavity(mesh, blend), segmentOfTriangle);
}

std::vector<double> EdgePrices(
  const TriangleMesh& mesh, const std::vector<double>& concavity, double preference)
{
  constexpr double leastShare = 0.05; // of its length: no edge is for nothing
  const double diagonal = std::max(mesh.BoundingBoxDiagonal(), 1e-300);
  std::vector<double> prices(concavity.size(), 0.0);
  for (int h = 0; h < static_cast<int>(prices.size()); ++h)
  {
    if (mesh.Opposite[h] > h)
    {
      prices[h] =
        EdgeLength(mesh, h) / diagonal * std::max(std::exp(-preference * concavity[h]), leastShare);
    }
  }
  return prices;
}
}
