// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceShapes.h"
#include "VolumeWrap.h"

#include <limits>
#include <numeric>

using namespace marrow;
using namespace marrow::test;

TEST(SurfaceBodies, BodiesApartStayAsTheyAre)
{
  PolygonMesh mesh = ToPolygons(MakeSphere(1.0, 3));
  Append(mesh, ToPolygons(Translated(MakeSphere(2.0, 3), { 4.0, 0.0, 0.0 })));
  const WorkingSurface surface = Compute(mesh);
  EXPECT_TRUE(surface.IsInput) << surface.Sentence();
  ExpectClosed(surface, 0, 2);
  // The larger one is body 0.
  EXPECT_EQ(surface.BodyOfTriangle.front(), 1);
  EXPECT_EQ(surface.BodyOfTriangle.back(), 0);
}

TEST(SurfaceBodies, InnerPartsAreLeftOut)
{
  const TriangleMesh outer = MakeSphere(1.0, 3);
  PolygonMesh mesh = ToPolygons(outer);
  Append(mesh, ToPolygons(Translated(MakeSphere(0.3, 3), { 0.2, 0.1, 0.3 })));
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectSame(surface.Mesh, outer);
  EXPECT_EQ(surface.Report.LeftOutParts, 1);
  // A face of the inner one goes to the outer one's nearest.
  const int cell = outer.NumberOfTriangles() + 17;
  EXPECT_EQ(surface.CellOfFullTriangle[surface.FullTriangleOfCell[cell]], cell);
  const Eigen::Vector3d middle = surface.Full.Centroid(surface.FullTriangleOfCell[cell]);
  EXPECT_GT(outer.Centroid(surface.TriangleOfCell(cell)).dot(middle), 0.9 * middle.norm());
}

TEST(SurfaceBodies, CrumbsAreLeftOut)
{
  const TriangleMesh body = MakeSphere(1.0, 3);
  PolygonMesh mesh = ToPolygons(body);
  for (int i = 0; i < 20; ++i)
  {
    Append(mesh,
      ToPolygons(Translated(MakeSphere(0.01, 1), { 2.0 * std::cos(i), 2.0 * std::sin(i), 0.5 })));
  }
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectSame(surface.Mesh, body);
  EXPECT_EQ(surface.Report.LeftOutParts, 20);
}

TEST(SurfaceBodies, PartsThatOverlapBecomeOne)
{
  const TriangleMesh ball = MakeSphere(1.0, 4);
  PolygonMesh mesh = ToPolygons(ball);
  const double distance = 1.2;
  Append(mesh, ToPolygons(Translated(Rotated(ball, { 1, 2, 3 }, 0.5), { distance, 0.0, 0.0 })));
  const WorkingSurface surface = Compute(mesh, 5000);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.UnitedParts, 2);
  EXPECT_LE(surface.Mesh.NumberOfTriangles(), 5000);
  // Two balls without the lens that they share.
  const double lens = Pi * (4.0 + distance) * (2.0 - distance) * (2.0 - distance) / 12.0;
  EXPECT_NEAR(SignedVolume(surface.Mesh), 8.0 * Pi / 3.0 - lens, 0.02 * 8.0);
  for (const auto& point : surface.Mesh.Points)
  {
    const double nearest =
      std::min(point.norm(), (point - Eigen::Vector3d(distance, 0.0, 0.0)).norm());
    EXPECT_NEAR(nearest, 1.0, 0.05);
  }
}

TEST(SurfaceBodies, WithoutABoundOnItsSizeTheWrapStillHasOne)
{
  PolygonMesh mesh = MakeCube();
  Append(mesh, MakeCube({ 0.5, 0.25, 0.25 }));
  const WorkingSurface surface = Compute(mesh, std::numeric_limits<int>::max());
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_LT(surface.Mesh.NumberOfTriangles(), 100000);
}

TEST(SurfaceBodies, PartsThatTouchAlongAFaceBecomeOne)
{
  PolygonMesh mesh = MakeCube();
  Append(mesh, MakeCube({ 1.0, 0.25, 0.25 }, 0.5));
  const WorkingSurface surface = Compute(mesh, 2000);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.UnitedParts, 2);
  EXPECT_NEAR(SignedVolume(surface.Mesh), 1.125, 0.03);
}

TEST(SurfaceBodies, ASoupIsWrapped)
{
  // Every triangle drawn in by a hundredth: no edge meets another.
  const TriangleMesh ball = MakeSphere(1.0, 4);
  PolygonMesh soup;
  for (int t = 0; t < ball.NumberOfTriangles(); ++t)
  {
    const Eigen::Vector3d middle = ball.Centroid(t);
    const int first = soup.NumberOfPoints();
    for (int corner : ball.Triangles[t])
    {
      soup.Points.push_back(middle + 0.99 * (ball.Points[corner] - middle));
    }
    AddPolygon(soup, { first, first + 1, first + 2 });
  }
  const WorkingSurface surface = Compute(soup, 4000);
  ExpectSound(soup, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.WrappedShreds, ball.NumberOfTriangles());
  EXPECT_NEAR(SignedVolume(surface.Mesh), 4.0 * Pi / 3.0, 0.1);
}

TEST(SurfaceBodies, TrianglesThatAgreeOnNoInsideAreWrappedAtADistance)
{
  const TriangleMesh ball = MakeSphere(1.0, 3);
  TriangleMesh flipped = ball;
  std::mt19937 random(9);
  for (auto& triangle : flipped.Triangles)
  {
    if (random() % 2 == 0)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  std::vector<int> all(flipped.Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const TriangleMesh wrap = WrapVolume(flipped, all, 0.05, 1000);
  EXPECT_EQ(CheckMesh(wrap).ManifoldError(), "");
  EXPECT_TRUE(CheckMesh(wrap).IsClosed());
  EXPECT_EQ(CheckMesh(wrap).NumberOfComponents, 1); // the cavity is left out
  EXPECT_NEAR(SignedVolume(wrap), 4.0 * Pi / 3.0 * 1.05 * 1.05 * 1.05, 0.15);
}
