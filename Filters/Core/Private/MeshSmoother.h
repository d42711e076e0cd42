// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshSmoother_h
#define marrow_MeshSmoother_h

#include "TriangleMesh.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace marrow
{
/// Smooths values given per vertex over a surface by one implicit step of the heat equation,
/// (M + width² K) x = M x₀ with lumped areas M and cotangent weights K. An edge between two values
/// becomes a ramp of about `width` to both sides whatever the resolution; weights are never
/// negative, so the result stays within the bounds of the input and shares keep summing to one.
class MeshSmoother
{
public:
  /// Factors the matrix once; each column smoothed later is cheap.
  MeshSmoother(const TriangleMesh& mesh, double width);

  double GetWidth() const { return this->Width; }

  /// One row per vertex, one column per quantity.
  Eigen::MatrixXd Smooth(const Eigen::MatrixXd& values) const;

private:
  /// The factor is read once for some columns, which lie beside each other.
  static constexpr int ColumnsAtOnce = 4;
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, ColumnsAtOnce, Eigen::RowMajor>;
  void Solve(Columns& columns) const;

  double Width;
  Eigen::VectorXd Mass;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> Solver;
};

/// Half the sum of the cotangents opposite to each half-edge's edge would be the usual weight; this
/// is one triangle's part of it for the half-edge h, never below `least`.
double CotangentWeight(const TriangleMesh& mesh, int halfEdge, double least);
}

#endif
