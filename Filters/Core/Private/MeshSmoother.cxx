// SPDX-License-Identifier: BSD-3-Clause
#include "MeshSmoother.h"

#include "Cotangent.h"
#include "ParallelFor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace marrow
{
double CotangentWeight(const TriangleMesh& mesh, int halfEdge, double least)
{
  const double cotangent =
    BoundedCotangent(mesh.Points[mesh.From(TriangleMesh::Previous(halfEdge))],
      mesh.Points[mesh.From(halfEdge)], mesh.Points[mesh.To(halfEdge)]);
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
  constexpr double ofMean = 1e-9;
  const double least = total > 0.0 ? ofMean * total / n : 1.0;
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
  const Eigen::Index blocks = (values.cols() + ColumnsAtOnce - 1) / ColumnsAtOnce;
  Eigen::MatrixXd result(values.rows(), values.cols());
  ParallelFor(0, static_cast<int>(blocks),
    [&](int first, int last)
    {
      for (Eigen::Index block = first; block < last; ++block)
      {
        const Eigen::Index begin = block * ColumnsAtOnce;
        const Eigen::Index count = std::min<Eigen::Index>(ColumnsAtOnce, values.cols() - begin);
        Columns columns = Columns::Zero(values.rows(), ColumnsAtOnce);
        columns.leftCols(count) =
          this->Solver.permutationP() * (this->Mass.asDiagonal() * values.middleCols(begin, count));
        this->Solve(columns);
        result.middleCols(begin, count) = this->Solver.permutationPinv() * columns.leftCols(count);
      }
    });
  return result;
}

void MeshSmoother::Solve(Columns& columns) const
{
  const Eigen::SparseMatrix<double>& factor = this->Solver.matrixL().nestedExpression();
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  for (Eigen::Index j = 0; j < factor.cols(); ++j)
  {
    Entry entry(factor, j); // the diagonal comes first
    columns.row(j) /= entry.value();
    for (++entry; entry; ++entry)
    {
      columns.row(entry.row()) -= entry.value() * columns.row(j);
    }
  }
  for (Eigen::Index j = factor.cols(); j-- > 0;)
  {
    Entry entry(factor, j);
    const double diagonal = entry.value();
    for (++entry; entry; ++entry)
    {
      columns.row(j) -= entry.value() * columns.row(entry.row());
    }
    columns.row(j) /= diagonal;
  }
}
}
