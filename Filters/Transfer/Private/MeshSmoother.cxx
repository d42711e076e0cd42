// SPDX-License-Identifier: BSD-3-Clause
#include "MeshSmoother.h"

#include "ParallelFor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace marrow
{
double CotangentWeight(const TriangleMesh& mesh, int halfEdge, double least)
{
  const Eigen::Vector3d& apex = mesh.Points[mesh.From(TriangleMesh::Previous(halfEdge))];
  const Eigen::Vector3d a = mesh.Points[mesh.From(halfEdge)] - apex;
  const Eigen::Vector3d b = mesh.Points[mesh.To(halfEdge)] - apex;
  const double twiceArea = a.cross(b).norm();
  // A sliver's cotangent is cut off: it would glue its two vertices together.
  const double cotangent = twiceArea > 0.0 ? std::min(a.dot(b) / twiceArea, 20.0) : 0.0;
  return std::max(0.5 * cotangent, least);
}

MeshSmoother::MeshSmoother(const TriangleMesh& mesh, double width)
  : Width(width)
{
  const int n = mesh.NumberOfVertices();
  const std::vector<double> areas = mesh.VertexAreas();
  double total = 0.0;
  for (double area : areas)
  {
    total += area;
  }
  // A point without area (unused, or only in degenerate triangles) still needs an equation.
  const double least = total > 0.0 ? 1e-9 * total / n : 1.0;
  this->Mass.resize(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(n) + 12 * mesh.Triangles.size());
  for (int v = 0; v < n; ++v)
  {
    this->Mass[v] = std::max(areas[v], least);
    entries.emplace_back(v, v, this->Mass[v]);
  }
  for (int h = 0; h < 3 * mesh.NumberOfTriangles(); ++h)
  {
    const double weight = width * width * CotangentWeight(mesh, h, 0.0);
    const int a = mesh.From(h);
    const int b = mesh.To(h);
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  this->Solver.compute(matrix);
}

Eigen::MatrixXd MeshSmoother::Smooth(const Eigen::MatrixXd& values) const
{
  Eigen::MatrixXd result(values.rows(), values.cols());
  ParallelFor(0, static_cast<int>(values.cols()),
    [&](int first, int last)
    {
      for (int c = first; c < last; ++c)
      {
        result.col(c) = this->Solver.solve(this->Mass.cwiseProduct(values.col(c)));
      }
    });
  return result;
}
}
