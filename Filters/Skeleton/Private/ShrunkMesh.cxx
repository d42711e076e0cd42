// SPDX-License-Identifier: BSD-3-Clause
#include "ShrunkMesh.h"

#include "Constants.h"
#include "Cotangent.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/// The three coordinates, and a zero that lets whole registers be loaded.
using Row = Eigen::Vector4d;
using Rows = std::vector<Row, Eigen::aligned_allocator<Row>>;

/// A symmetric matrix of a row per vertex: what it has on the diagonal, and minus a weight for each neighbour.
struct SmoothingSystem
{
  struct Entry
  {
    int Neighbor;
    double Weight;
  };
  std::vector<double> Diagonal;
  std::vector<int> Offsets = { 0 }; ///< per vertex, into Others
  std::vector<Entry> Others;

  Row Product(int v, const Rows& values) const
  {
    Row sum = this->Diagonal[v] * values[v];
    for (int i = this->Offsets[v]; i < this->Offsets[v + 1]; ++i)
    {
      sum -= this->Others[i].Weight * values[this->Others[i].Neighbor];
    }
    return sum;
  }
};

/// By coordinate; 0 where there is nothing to go on with, as one that is solved exactly.
Row Ratio(const Row& a, const Row& b)
{
  return (b.array() > 0.0).select(a.array() / b.array(), 0.0);
}

/// Conjugate gradients with the diagonal as the preconditioner. Unlike Eigen's they take the three coordinates in
/// step, and so read the matrix once for all of them. The smoothing is local, so a few dozen steps reach far below
/// what the slices themselves are worth.
void Solve(const SmoothingSystem& system, const Rows& right, Rows& solution)
{
  constexpr double tolerance = 1e-6;  // far below what the collapse can see
  constexpr int mostIterations = 500; // only a bound; some 50 are needed
  const int size = static_cast<int>(right.size());
  Rows residual(size);
  Rows direction(size);
  Rows product(size);
  Row enough = Row::Zero();
  Row energy = Row::Zero();
  Row left = Row::Zero();
  for (int v = 0; v < size; ++v)
  {
    residual[v] = right[v] - system.Product(v, solution);
    direction[v] = residual[v] / system.Diagonal[v];
    enough += tolerance * tolerance * right[v].cwiseProduct(right[v]);
    energy += residual[v].cwiseProduct(direction[v]);
    left += residual[v].cwiseProduct(residual[v]);
  }
  for (int i = 0; i < mostIterations && (left.array() > enough.array()).any(); ++i)
  {
    Row curvature = Row::Zero();
    for (int v = 0; v < size; ++v)
    {
      product[v] = system.Product(v, direction);
      curvature += direction[v].cwiseProduct(product[v]);
    }
    // A coordinate that is solved stays as it is, so that none depends on the others.
    const Row step = (left.array() > enough.array()).select(Ratio(energy, curvature), 0.0);
    Row next = Row::Zero();
    left.setZero();
    for (int v = 0; v < size; ++v)
    {
      solution[v] += step.cwiseProduct(direction[v]);
      residual[v] -= step.cwiseProduct(product[v]);
      const Row square = residual[v].cwiseProduct(residual[v]);
      left += square;
      next += square / system.Diagonal[v];
    }
    const Row turn = Ratio(next, energy);
    energy = next;
    for (int v = 0; v < size; ++v)
    {
      direction[v] = residual[v] / system.Diagonal[v] + turn.cwiseProduct(direction[v]);
    }
  }
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

  std::vector<double> edgeWeight(mesh.Opposite.size());
  for (int h = 0; h < 3 * mesh.NumberOfTriangles(); ++h)
  {
    const double length =
      SmoothingLength * 0.5 * (perimeter[mesh.From(h)] + perimeter[mesh.To(h)]) / (2.0 * Pi);
    edgeWeight[h] = 0.5 * ClampedCotangent(mesh, h) * length * length;
  }
  SmoothingSystem system;
  system.Offsets.reserve(mesh.Points.size() + 1);
  system.Others.reserve(mesh.Opposite.size());
  Rows right(numberOfVertices);
  Rows solution(numberOfVertices);
  for (int v = 0; v < numberOfVertices; ++v)
  {
    // A point that no triangle uses keeps its own place: any positive weight does.
    const bool used = area[v] > 0.0;
    const double weight = used ? area[v] * std::max(reliability[v], LeastReliability) : 1.0;
    const Eigen::Vector3d& target = used ? sliceCenter[v] : mesh.Points[v];
    double diagonal = weight;
    const auto join = [&](int other, double weightOfEdge)
    {
      system.Others.push_back({ other, weightOfEdge });
      diagonal += weightOfEdge;
    };
    mesh.ForEachOutgoing(v,
      [&](int h)
      {
        const int opposite = mesh.Opposite[h];
        join(mesh.To(h), edgeWeight[h] + (opposite >= 0 ? edgeWeight[opposite] : 0.0));
        const int incoming = TriangleMesh::Previous(h);
        if (mesh.Opposite[incoming] < 0)
        {
          join(mesh.From(incoming), edgeWeight[incoming]);
        }
      });
    system.Diagonal.push_back(diagonal);
    system.Offsets.push_back(static_cast<int>(system.Others.size()));
    solution[v] << target, 0.0;
    right[v] = weight * solution[v];
  }
  Solve(system, right, solution);

  std::vector<Eigen::Vector3d> shrunk(numberOfVertices);
  for (int v = 0; v < numberOfVertices; ++v)
  {
    shrunk[v] = solution[v].head<3>();
  }
  return shrunk;
}
}
