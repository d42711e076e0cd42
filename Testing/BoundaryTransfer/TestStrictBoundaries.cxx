// SPDX-License-Identifier: BSD-3-Clause
#include "StrictBoundaries.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

using namespace marrow;

namespace
{
/// A labelled surface and its loops carried to itself.
struct Carried
{
  TriangleMesh Mesh;
  std::vector<int> Labels;
  SegmentPieces Pieces;
  std::vector<SegmentLoop> Loops;

  template <typename LabelOf>
  Carried(TriangleMesh mesh, LabelOf&& labelOf)
    : Mesh(std::move(mesh))
  {
    for (int t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
    {
      this->Labels.push_back(labelOf(this->Mesh.Centroid(t)));
    }
    this->Pieces = FindPieces(this->Mesh, this->Labels);
    this->Loops = FindLoops(this->Mesh, this->Pieces);
  }
  /// As if the loop had been carried to where it is; `near` says which triangles its region holds.
  template <typename Near>
  CarriedLoop Cut(int loop, Near&& near) const
  {
    CarriedLoop cut;
    cut.Loop = loop;
    cut.Cut.LeftIsFront = true;
    for (int t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
    {
      if (near(this->Mesh.Centroid(t)))
      {
        const bool isLeft = this->Pieces.PieceOfTriangle[t] == this->Loops[loop].LeftPiece;
        cut.Cut.Sides.emplace_back(t, static_cast<char>(isLeft ? 0 : 1));
      }
    }
    return cut;
  }
};
}

TEST(StrictBoundaries, PiecesBesideALostLoopBecomeOneUnderTheLargestsLabel)
{
  const Carried tube(test::MakeCylinder(1.0, 6.0, 24, 60),
    [](const Eigen::Vector3d& p) { return p.z() > 1.0 ? 7
                                     : p.z() > 0.0    ? 8
                                                      : 9; });
  ASSERT_EQ(tube.Loops.size(), 2u);
  const auto labelOfLoop = [&](int i)
  {
    return std::set<int>{ tube.Pieces.LabelOfPiece[tube.Loops[i].LeftPiece],
      tube.Pieces.LabelOfPiece[tube.Loops[i].RightPiece] };
  };
  const int upper = labelOfLoop(0) == std::set<int>{ 7, 8 } ? 0 : 1;
  const SegmentPieces merged = MergePieces(
    tube.Pieces, tube.Loops, { tube.Cut(upper, [](const Eigen::Vector3d&) { return true; }) });
  ASSERT_EQ(merged.NumberOfPieces(), 2);
  for (int t = 0; t < tube.Mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_EQ(merged.LabelOfPiece[merged.PieceOfTriangle[t]], tube.Labels[t] == 7 ? 7 : 9);
  }
  EXPECT_NEAR(merged.AreaOfPiece[0] + merged.AreaOfPiece[1],
    tube.Pieces.AreaOfPiece[0] + tube.Pieces.AreaOfPiece[1] + tube.Pieces.AreaOfPiece[2], 1e-9);
}

TEST(StrictBoundaries, ACurveKeepsOutWhatLiesBeyondIt)
{
  const Carried tube(test::MakeCylinder(1.0, 6.0, 24, 60),
    [](const Eigen::Vector3d& p) { return p.z() > 1.0 ? 7
                                     : p.z() > 0.0    ? 8
                                                      : 9; });
  std::vector<CarriedLoop> carried;
  for (int i = 0; i < 2; ++i)
  {
    const double z = tube.Mesh.Points[tube.Loops[i].Vertices(tube.Mesh).front()].z() > 0.5 ? 1 : 0;
    carried.push_back(
      tube.Cut(i, [z](const Eigen::Vector3d& p) { return std::abs(p.z() - z) < 0.3; }));
  }
  const auto beyond =
    PiecesBeyondCurves(tube.Mesh, tube.Pieces, tube.Loops, carried, tube.Mesh.NumberOfTriangles());
  for (int t = 0; t < tube.Mesh.NumberOfTriangles(); ++t)
  {
    const double z = tube.Mesh.Centroid(t).z();
    std::set<int> labels;
    for (const int piece : beyond[t])
    {
      labels.insert(tube.Pieces.LabelOfPiece[piece]);
    }
    const std::set<int> expected = std::abs(z - 1.0) < 0.3
      ? (z > 1.0 ? std::set<int>{ 8, 9 } : std::set<int>{ 7 })
      : std::abs(z) < 0.3 ? (z > 0.0 ? std::set<int>{ 9 } : std::set<int>{ 7, 8 })
                          : std::set<int>{};
    EXPECT_EQ(labels, expected) << z;
  }
}

TEST(StrictBoundaries, ALoopRoundAHandleHasSidesNearByOnly)
{
  // A ring in two halves: neither of its two boundaries separates the surface.
  const Carried ring(test::MakeTorus(2.0, 0.5, 48, 16),
    [](const Eigen::Vector3d& p) { return p.y() > 0.0 ? 1 : 0; });
  ASSERT_EQ(ring.Loops.size(), 2u);
  const double x = ring.Mesh.Points[ring.Loops[0].Vertices(ring.Mesh).front()].x();
  const auto near = [x](const Eigen::Vector3d& p)
  { return p.x() * x > 0.0 && std::abs(p.y()) < 1.0; };
  const auto beyond = PiecesBeyondCurves(
    ring.Mesh, ring.Pieces, ring.Loops, { ring.Cut(0, near) }, ring.Mesh.NumberOfTriangles());
  for (int t = 0; t < ring.Mesh.NumberOfTriangles(); ++t)
  {
    const std::vector<int> other{ 1 - ring.Pieces.PieceOfTriangle[t] };
    EXPECT_EQ(beyond[t], near(ring.Mesh.Centroid(t)) ? other : std::vector<int>{});
  }
}
