// SPDX-License-Identifier: BSD-3-Clause
#include "RegionMatch.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

using namespace marrow;

namespace
{
/// A cylinder that is cut across at half its height, and the cut as if it had been transferred.
struct CutCylinder
{
  TriangleMesh Mesh = test::MakeCylinder(1.0, 6.0, 24, 30);
  std::vector<SegmentLoop> Loops;
  std::vector<LoopCut> Cuts;
  int Bottom = -1;
  int Top = -1;

  CutCylinder()
  {
    std::vector<int> labels;
    LoopCut cut;
    cut.Loop = 0;
    for (int t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
    {
      const double z = this->Mesh.Centroid(t).z();
      labels.push_back(z > 0.0 ? 1 : 0);
      cut.Cut.Sides.emplace_back(t, static_cast<char>(z > 0.0));
      this->Bottom = z < -2.5 ? t : this->Bottom;
      this->Top = z > 2.5 ? t : this->Top;
    }
    const SegmentPieces pieces = FindPieces(this->Mesh, labels);
    this->Loops = FindLoops(this->Mesh, pieces);
    const int left = TriangleMesh::TriangleOf(this->Loops[0].HalfEdges.front());
    cut.Cut.LeftIsFront = labels[left] == 0;
    this->Cuts.push_back(std::move(cut));
  }
};
}

TEST(RegionMatch, RegionsLieOnTheSameSideOfTheLoop)
{
  CutCylinder shape;
  ASSERT_EQ(shape.Loops.size(), 1u);
  const RegionMatch match = MatchRegions(shape.Mesh, shape.Mesh, shape.Loops,
    { { shape.Bottom, shape.Bottom }, { shape.Top, shape.Top } }, shape.Cuts);
  EXPECT_EQ(shape.Cuts.size(), 1u);
  for (int t = 0; t < shape.Mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_EQ(match.SourceRegion[match.RegionOfTriangle[t]], match.SourceRegionOfTriangle[t]);
  }
}

TEST(RegionMatch, ALoopThatPartsTheLandmarksOtherwiseIsDropped)
{
  // The source has the landmarks on either side of the loop, the target both on one.
  CutCylinder shape;
  const RegionMatch match = MatchRegions(shape.Mesh, shape.Mesh, shape.Loops,
    { { shape.Bottom, shape.Bottom }, { shape.Top, shape.Bottom } }, shape.Cuts);
  EXPECT_TRUE(shape.Cuts.empty());
  EXPECT_EQ(match.SourceRegion.size(), 1u);
}
