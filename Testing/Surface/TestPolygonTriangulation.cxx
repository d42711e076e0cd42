// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonTriangulation.h"
#include "SurfaceShapes.h"

#include <set>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// Sum of the areas, signed along z; equal to the polygon's own only if no triangle lies outside.
double Areas(const std::vector<Eigen::Vector3d>& corners, double& unsignedSum)
{
  double sum = 0.0;
  unsignedSum = 0.0;
  for (const auto& t : TriangulatePolygon(corners))
  {
    const double area =
      0.5 * (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]])[2];
    sum += area;
    unsignedSum += std::abs(area);
  }
  return sum;
}
}

TEST(PolygonTriangulation, ConcavePolygonsAreCutInside)
{
  // A star, a comb, and a quadrilateral like an arrow head whose short diagonal lies outside.
  std::vector<Eigen::Vector3d> star;
  for (int i = 0; i < 14; ++i)
  {
    const double r = i % 2 == 0 ? 1.0 : 0.2;
    star.push_back({ r * std::cos(2.0 * Pi * i / 14), r * std::sin(2.0 * Pi * i / 14), 3.0 });
  }
  const std::vector<Eigen::Vector3d> comb{ { 0, 0, 0 }, { 5, 0, 0 }, { 5, 3, 0 }, { 4, 3, 0 },
    { 4, 1, 0 }, { 3, 1, 0 }, { 3, 3, 0 }, { 2, 3, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 3, 0 },
    { 0, 3, 0 } };
  const std::vector<Eigen::Vector3d> arrow{ { 0, 0, 0 }, { 4, -1, 0 }, { 1, 0, 0 }, { 4, 1, 0 } };
  double unsignedSum = 0.0;
  EXPECT_NEAR(Areas(star, unsignedSum), 7 * 0.2 * std::sin(2.0 * Pi / 14), 1e-12);
  EXPECT_NEAR(unsignedSum, 7 * 0.2 * std::sin(2.0 * Pi / 14), 1e-12);
  EXPECT_NEAR(Areas(comb, unsignedSum), 11.0, 1e-12);
  EXPECT_NEAR(unsignedSum, 11.0, 1e-12);
  EXPECT_NEAR(Areas(arrow, unsignedSum), 1.0, 1e-12);
  EXPECT_NEAR(unsignedSum, 1.0, 1e-12);
}

TEST(PolygonTriangulation, CornersOnALineLeaveNoFlatTriangle)
{
  const std::vector<Eigen::Vector3d> corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 },
    { 0, 2, 0 } };
  const auto triangles = TriangulatePolygon(corners);
  ASSERT_EQ(triangles.size(), 3u);
  for (const auto& t : triangles)
  {
    EXPECT_NEAR(
      (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).norm(), 2.0, 1e-12);
  }
}

TEST(PolygonTriangulation, SelfCrossingPolygonsStillGiveTriangles)
{
  const std::vector<Eigen::Vector3d> bowTie{ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  std::vector<Eigen::Vector3d> pentagram;
  for (int i = 0; i < 5; ++i)
  {
    pentagram.push_back({ std::cos(4.0 * Pi * i / 5), std::sin(4.0 * Pi * i / 5), 0.0 });
  }
  for (const auto& polygon : { bowTie, pentagram })
  {
    const auto triangles = TriangulatePolygon(polygon);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    std::set<int> corners;
    for (const auto& t : triangles)
    {
      corners.insert(t.begin(), t.end());
    }
    EXPECT_EQ(corners.size(), polygon.size());
  }
}

TEST(PolygonTriangulation, TheCutDoesNotDependOnWhereThePolygonStarts)
{
  const std::vector<Eigen::Vector3d> corners{ { 0, 0, 0 }, { 3, 0.2, 0 }, { 4, 2, 0.1 },
    { 2, 1.5, 0 }, { 1.5, 4, 0 }, { -0.5, 2, 0 } };
  auto cut = [&](int start)
  {
    std::vector<Eigen::Vector3d> turned;
    for (int i = 0; i < 6; ++i)
    {
      turned.push_back(corners[(i + start) % 6]);
    }
    std::set<std::set<int>> triangles;
    for (const auto& t : TriangulatePolygon(turned))
    {
      triangles.insert({ (t[0] + start) % 6, (t[1] + start) % 6, (t[2] + start) % 6 });
    }
    return triangles;
  };
  for (int start = 1; start < 6; ++start)
  {
    EXPECT_EQ(cut(start), cut(0)) << start;
  }
}

TEST(PolygonTriangulation, RepeatedCornersAndEveryPolygonsFaceAreKept)
{
  PolygonMesh mesh = MakeCube();
  AddPolygon(mesh, { 0, 0, 1, 1 });    // a line
  AddPolygon(mesh, { 0, 2, 2, 3, 1 }); // the first face again, a corner twice
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Mesh.NumberOfTriangles(), 12);
  EXPECT_EQ(surface.Report.FacesTwice, 2); // triangles
  EXPECT_EQ(surface.Report.FacesWithoutArea, 1);
}
