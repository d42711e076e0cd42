// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryPlacement.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

using namespace marrow;

namespace
{
/// A ring in two halves: neither of its two boundaries separates the surface.
struct Halves
{
  AnalyzedMesh Side;
  SegmentPieces Pieces;
  std::vector<SegmentLoop> Loops;
  GuidedMap Map;

  Halves()
  {
    this->Side.Mesh = test::MakeTorus(2.0, 0.5, 48, 16);
    const TriangleMesh& mesh = this->Side.Mesh;
    std::vector<int> labels;
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      labels.push_back(mesh.Centroid(t).y() > 0.0 ? 1 : 0);
    }
    this->Pieces = FindPieces(mesh, labels);
    this->Loops = FindLoops(mesh, this->Pieces);
    this->Map.Shares = Eigen::MatrixXd::Zero(mesh.NumberOfVertices(), 2);
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      for (int corner : mesh.Triangles[t])
      {
        this->Map.Shares.row(corner).setZero();
        this->Map.Shares(corner, this->Pieces.PieceOfTriangle[t]) = 1.0;
      }
    }
  }
  /// The loop on itself as target, or turned round.
  double DisagreementOf(const SegmentLoop& loop, bool swapped) const
  {
    BoundaryTransfer::Cut cut;
    const double x = this->Side.Mesh.Points[loop.Vertices(this->Side.Mesh).front()].x();
    for (int t = 0; t < this->Side.Mesh.NumberOfTriangles(); ++t)
    {
      const Eigen::Vector3d center = this->Side.Mesh.Centroid(t);
      if (center.x() * x > 0.0 && std::abs(center.y()) < 1.0)
      {
        const bool isLeft = this->Pieces.PieceOfTriangle[t] == loop.LeftPiece;
        cut.Sides.emplace_back(t, static_cast<char>(isLeft == swapped ? 0 : 1));
      }
    }
    cut.LeftIsFront = false;
    return Disagreement(this->Side, this->Side, loop, cut, this->Pieces, this->Map);
  }
};
}

TEST(BoundaryPlacement, ALoopRoundAHandleHasTwoSides)
{
  const Halves halves;
  ASSERT_EQ(2u, halves.Loops.size());
  for (const SegmentLoop& loop : halves.Loops)
  {
    EXPECT_LT(halves.DisagreementOf(loop, false), 0.1);
    EXPECT_GT(halves.DisagreementOf(loop, true), 0.9);
  }
}
