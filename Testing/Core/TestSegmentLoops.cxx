// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentLoops.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// A tube about the z axis, and where its triangles are.
struct Tube
{
  TriangleMesh Mesh = MakeCylinder(0.5, 4.0, 32, 60);

  Tube() { this->Mesh.BuildConnectivity(); }
  /// Of the length.
  double Fraction(int triangle) const { return this->Mesh.Centroid(triangle).z() / 4.0 + 0.5; }
  double Angle(int triangle) const
  {
    const Eigen::Vector3d centroid = this->Mesh.Centroid(triangle);
    return std::atan2(centroid.y(), centroid.x());
  }
};
}

TEST(SegmentLoops, ThreeBandsHaveTwoLoops)
{
  const Tube tube;
  std::vector<int> labels;
  for (int t = 0; t < tube.Mesh.NumberOfTriangles(); ++t)
  {
    const double f = tube.Fraction(t);
    labels.push_back(f < 0.3 ? 5 : (f < 0.6 ? -2 : 5));
  }
  const SegmentPieces pieces = FindPieces(tube.Mesh, labels);
  EXPECT_EQ(pieces.NumberOfPieces(), 3); // the two ends are pieces of one segment
  const auto loops = FindLoops(tube.Mesh, pieces);
  ASSERT_EQ(loops.size(), 2u);
  for (const SegmentLoop& loop : loops)
  {
    EXPECT_NE(pieces.LabelOfPiece[loop.LeftPiece], pieces.LabelOfPiece[loop.RightPiece]);
    for (std::size_t i = 0; i < loop.HalfEdges.size(); ++i)
    {
      const int h = loop.HalfEdges[i];
      EXPECT_EQ(tube.Mesh.To(h), tube.Mesh.From(loop.HalfEdges[(i + 1) % loop.HalfEdges.size()]));
      EXPECT_EQ(pieces.PieceOfTriangle[TriangleMesh::TriangleOf(h)], loop.LeftPiece);
    }
  }
}

TEST(SegmentLoops, ThreeWayJunctionsGiveClosedLoopsOnce)
{
  // Two halves of the tube's lower part and its upper part meet in two junction vertices.
  const Tube tube;
  std::vector<int> labels;
  for (int t = 0; t < tube.Mesh.NumberOfTriangles(); ++t)
  {
    labels.push_back(tube.Fraction(t) > 0.5 ? 0 : (tube.Angle(t) > 0.0 ? 1 : 2));
  }
  const SegmentPieces pieces = FindPieces(tube.Mesh, labels);
  ASSERT_EQ(pieces.NumberOfPieces(), 3);
  const auto loops = FindLoops(tube.Mesh, pieces);
  // Two of the three border loops cover every edge; the third would say nothing new.
  EXPECT_EQ(loops.size(), 2u);
}
