// SPDX-License-Identifier: BSD-3-Clause
#include "MeshSmoother.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace marrow;
using namespace marrow::test;

TEST(MeshSmoother, KeepsConstantsSumsAndBounds)
{
  TriangleMesh mesh = MakeCylinder(0.5, 4.0, 32, 60);
  mesh.BuildConnectivity();
  Eigen::MatrixXd values(mesh.NumberOfVertices(), 2);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    values(v, 0) = mesh.Points[v].z() > 0.0 ? 1.0 : 0.0;
    values(v, 1) = 1.0 - values(v, 0);
  }
  const Eigen::MatrixXd smooth = MeshSmoother(mesh, 0.2).Smooth(values);
  EXPECT_LT((smooth.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-9);
  EXPECT_GE(smooth.minCoeff(), -1e-12);
  // exp(-x / width) beyond the step, on a fine enough mesh.
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (std::abs(mesh.Points[v].z() + 0.4) < 1e-9)
    {
      EXPECT_NEAR(smooth(v, 0), 0.5 * std::exp(-0.4 / 0.2), 0.03);
    }
  }
}
