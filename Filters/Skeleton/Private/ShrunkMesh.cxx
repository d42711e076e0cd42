// SPDX-License-Identifier: BSD-3-Clause
#include "ShrunkMesh.h"

#include "Constants.h"
#include "Cotangent.h"

#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace marrow
{
namespace
{
/// Of a perimeter along the surface: dMSP / ds on a cone of 30° half-angle, 2π sin 30°.
constexpr double MaximumSlope = Pi;
/// Length of smoothing over the local radius.
constexpr double SmoothingLength = 1.0 / 3.0;
/// No vertex is left without any say: keeps the system definite on a part without a good slice.
constexpr double LeastReliability = 1e-4;
/// The trust in a slice that did not close.
constexpr double InvalidReliability = 1e-2;

/// The Lipschitz lower envelope of `msp`: the largest function below it whose slope along the edges is at
/// most MaximumSlope.
std::vector<double> LipschitzEnvelope(const TriangleMesh& mesh, const std::vector<double>& msp)
{
  std::vector<double> limited = msp;
  using Entry = std::pair<double, int>;
  std::vector<Entry> entries(mesh.Points.size());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    entries[v] = { msp[v], v };
  }
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue(
    std::greater<Entry>(), std::move(entries));
  while (!queue.empty())
  {
    const auto [value, v] = queue.top();
    queue.pop();
    if (value > limited[v])
    {
      continue;
    }
    mesh.ForEachNeighbor(v,
      [&, from = v, base = value](int neighbor)
      {
        const double reached =
          base + MaximumSlope * (mesh.Points[neighbor] - mesh.Points[from]).norm();
        if (reached < limited[neighbor])
        {
          limited[neighbor] = reached;
          queue.push({ reached, neighbor });
        }
      });
  }
  return limited;
}

/// Cotangent of the angle opposite to a half-edge, clamped: a sliver must not rule the sum, nor an
/// obtuse angle push its edge apart.
double ClampedCotangent(const TriangleMesh& mesh, int halfEdge)
{
  constexpr double least = 0.05; // keeps a vertex from hanging on one neighbour alone
  return std::max(BoundedCotangent(mesh.Points[mesh.From(TriangleMesh::Previous(halfEdge))],
                    mesh.Points[mesh.From(halfEdge)], mesh.Points[mesh.To(halfEdge)]),
    least);
}
}

std::vector<double> SliceReliability(
  const TriangleMesh& mesh, const std::vector<double>& msp, const std::vector<unsigned char>& valid)
{
  std::vector<double> reliability = LipschitzEnvelope(mesh, msp);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const double ratio = msp[v] > 0.0 ? reliability[v] / msp[v] : 0.0;
    reliability[v] = ratio * ratio * (valid[v] ? 1.0 : InvalidReliability);
  }
  return reliability;
}

std::vector<Eigen::Vector3d> ShrinkMesh(const TriangleMesh& mesh, const std::vector<double>& msp,
  const std::vector<Eigen::Vector3d>& sliceCenter, const std::vector<double>& reliability)
{
  const int numberOfVertices = mesh.NumberOfVertices();
  const std::vector<double> area = mesh.VertexAreas();
  const std::vector<double> perimeter = LipschitzEnvelope(mesh, msp);

  Eigen::MatrixX3d right(numberOfVertices, 3);
  Eigen::MatrixX3d start(numberOfVertices, 3);
  std::vector<double> diagonal(numberOfVertices);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(7 * mesh.Points.size());
  for (int h = 0; h < 3 * mesh.NumberOfTriangles(); ++h)
  {
    const int i = mesh.From(h);
    const int j = mesh.To(h);
    const double length = SmoothingLength * 0.5 * (perimeter[i] + perimeter[j]) / (2.0 * Pi);
    const double weight = 0.5 * ClampedCotangent(mesh, h) * length * length;
    diagonal[i] += weight;
    diagonal[j] += weight;
    entries.emplace_back(i, j, -weight);
    entries.emplace_back(j, i, -weight);
  }
  for (int v = 0; v < numberOfVertices; ++v)
  {
    // A point that no triangle uses keeps its own place: any positive weight does.
    const double weight =
      area[v] > 0.0 ? area[v] * std::max(reliability[v], LeastReliability) : 1.0;
    const Eigen::Vector3d& target = area[v] > 0.0 ? sliceCenter[v] : mesh.Points[v];
    entries.emplace_back(v, v, diagonal[v] + weight);
    right.row(v) = weight * target.transpose();
    start.row(v) = target.transpose();
  }
  Eigen::SparseMatrix<double> matrix(numberOfVertices, numberOfVertices);
  matrix.setFromTriplets(entries.begin(), entries.end());

  // The smoothing is local, so a few dozen steps of conjugate gradients reach far below what the
  // slices themselves are worth.
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  constexpr double tolerance = 1e-6;  // far below what the collapse can see
  constexpr int mostIterations = 500; // only a bound; some 50 are needed
  solver.setTolerance(tolerance);
  solver.setMaxIterations(mostIterations);
  solver.compute(matrix);
  const Eigen::MatrixX3d solution = solver.solveWithGuess(right, start);

  std::vector<Eigen::Vector3d> shrunk(numberOfVertices);
  for (int v = 0; v < numberOfVertices; ++v)
  {
    shrunk[v] = solution.row(v).transpose();
  }
  return shrunk;
}
}
