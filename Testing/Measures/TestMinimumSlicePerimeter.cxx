// SPDX-License-Identifier: BSD-3-Clause
#include "MeasureShapes.h"
#include "MinimumSlicePerimeter.h"
#include "SliceWalker.h"
#include "SurfaceMeasures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace marrow;
using namespace marrow::test;

namespace
{
SliceField MSPOf(const TriangleMesh& mesh, int numberOfSlices = 12)
{
  SliceField field;
  EXPECT_TRUE(ComputeMinimumSlicePerimeter(mesh, numberOfSlices, field));
  return field;
}

void ExpectFinite(const TriangleMesh& mesh, const SliceField& field)
{
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_TRUE(std::isfinite(field.Perimeter[v])) << v;
    ASSERT_GE(field.Perimeter[v], 0.0) << v;
    ASSERT_TRUE(field.Center[v].allFinite()) << v;
    ASSERT_TRUE(field.Normal[v].allFinite()) << v;
  }
}

/// Length and centroid of the whole intersection of a mesh with a plane, triangle by triangle.
struct Section
{
  double Length = 0.0;
  Eigen::Vector3d Moment = Eigen::Vector3d::Zero();
};

Section SectionOf(
  const TriangleMesh& mesh, const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
{
  Section section;
  for (const auto& t : mesh.Triangles)
  {
    std::vector<Eigen::Vector3d> ends;
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d& a = mesh.Points[t[k]];
      const Eigen::Vector3d& b = mesh.Points[t[(k + 1) % 3]];
      const double da = normal.dot(a - origin);
      const double db = normal.dot(b - origin);
      if ((da >= 0.0) != (db >= 0.0))
      {
        ends.push_back(a + da / (da - db) * (b - a));
      }
    }
    if (ends.size() == 2)
    {
      const double length = (ends[0] - ends[1]).norm();
      section.Length += length;
      section.Moment += 0.5 * length * (ends[0] + ends[1]);
    }
  }
  return section;
}
}

TEST(SliceWalker, IsTheWholeSectionOfAConvexMesh)
{
  const TriangleMesh mesh = MakeEgg(3);
  const SliceWalker walker(mesh);
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  for (int v = 0; v < mesh.NumberOfVertices(); v += 7)
  {
    const Eigen::Vector3d plane = normals[v].unitOrthogonal();
    const Slice slice = walker.Walk(v, plane);
    const Section section = SectionOf(mesh, mesh.Points[v], plane);
    ASSERT_EQ(slice.Type, Slice::State::Closed) << v;
    EXPECT_NEAR(slice.Perimeter, section.Length, 1e-9) << v;
    EXPECT_LT((slice.Center - section.Moment / section.Length).norm(), 1e-9) << v;
  }
}

TEST(SliceWalker, ClosesWherePlanesRunThroughManyVertices)
{
  // The octahedron's own planes of symmetry hold whole edges.
  const TriangleMesh mesh = MakeSphere(1.0, 3);
  const SliceWalker walker(mesh);
  for (const Eigen::Vector3d& plane :
    { Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 1, 0) })
  {
    const Slice slice = walker.Walk(4, plane); // the pole on the z axis
    ASSERT_EQ(slice.Type, Slice::State::Closed);
    EXPECT_NEAR(slice.Perimeter, 2.0 * Pi, 0.02);
    EXPECT_LT(slice.Center.norm(), 1e-9);
  }
}

TEST(SliceWalker, AbandonsOnlyWhatExceedsTheBound)
{
  const TriangleMesh mesh = MakeEgg(3);
  const SliceWalker walker(mesh);
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  for (int v = 0; v < mesh.NumberOfVertices(); v += 5)
  {
    const Eigen::Vector3d plane = normals[v].unitOrthogonal();
    const Slice full = walker.Walk(v, plane);
    SliceBounds bounds;
    bounds.Closed = full.Perimeter;
    const Slice equal = walker.Walk(v, plane, bounds);
    ASSERT_EQ(equal.Type, Slice::State::Closed) << v;
    EXPECT_EQ(equal.Perimeter, full.Perimeter) << v;
    bounds.Closed = 0.7 * full.Perimeter;
    EXPECT_EQ(walker.Walk(v, plane, bounds).Type, Slice::State::Abandoned) << v;
  }
}

TEST(SliceWalker, HasNoCurveWhereThePlaneOnlyTouches)
{
  const TriangleMesh mesh = MakeSphere(1.0, 2);
  const SliceWalker walker(mesh);
  EXPECT_EQ(walker.Walk(4, Eigen::Vector3d(0, 0, 1)).Type, Slice::State::None);
  EXPECT_EQ(walker.Walk(4, Eigen::Vector3d(0, 0, -1)).Type, Slice::State::None);
}

TEST(MinimumSlicePerimeter, AgreesWithAllSlicesWalkedToTheEnd)
{
  const TriangleMesh mesh = MakeEgg(3);
  const int numberOfSlices = 12;
  const SliceField field = MSPOf(mesh, numberOfSlices);
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  const std::vector<Eigen::Vector3d> axes = LeastBendingDirections(mesh, normals);
  const SliceWalker walker(mesh);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    Slice best;
    for (int i = 0; i < numberOfSlices; ++i)
    {
      const double angle = Pi / numberOfSlices * i;
      const Eigen::Vector3d plane =
        std::cos(angle) * axes[v] + std::sin(angle) * normals[v].cross(axes[v]);
      const Slice slice = walker.Walk(v, plane);
      if (slice.Type == Slice::State::Closed &&
        (best.Type == Slice::State::None || slice.Perimeter < best.Perimeter))
      {
        best = slice;
      }
    }
    ASSERT_NEAR(field.Perimeter[v], best.Perimeter, 1e-12) << v;
    ASSERT_LT((field.Center[v] - best.Center).norm(), 1e-12) << v;
    ASSERT_EQ(field.Valid[v], 1) << v;
  }
}

TEST(MinimumSlicePerimeter, IsTheCircumferenceOfACylinder)
{
  const double radius = 0.7;
  const TriangleMesh mesh = MakeCylinder(radius, 12.0, 48, 90);
  const SliceField field = MSPOf(mesh);
  int checked = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (std::abs(mesh.Points[v].z()) > 4.0)
    {
      continue;
    }
    ++checked;
    EXPECT_NEAR(field.Perimeter[v], 2.0 * Pi * radius, 0.005 * 2.0 * Pi * radius) << v;
    EXPECT_LT(std::hypot(field.Center[v].x(), field.Center[v].y()), 0.005 * radius) << v;
    EXPECT_NEAR(field.Center[v].z(), mesh.Points[v].z(), 0.01 * radius) << v;
    EXPECT_GT(std::abs(field.Normal[v].z()), 0.999) << v;
    EXPECT_EQ(field.Valid[v], 1) << v;
  }
  EXPECT_GT(checked, 1000);
}

TEST(MinimumSlicePerimeter, IsTheTubeCircumferenceOfATorus)
{
  const double radius = 2.0;
  const double tube = 0.5;
  const TriangleMesh mesh = MakeTorus(radius, tube, 120, 40);
  const SliceField field = MSPOf(mesh);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_NEAR(field.Perimeter[v], 2.0 * Pi * tube, 0.015 * 2.0 * Pi * tube) << v;
    const Eigen::Vector3d& c = field.Center[v];
    ASSERT_LT(std::hypot(std::hypot(c.x(), c.y()) - radius, c.z()), 0.02 * tube) << v;
  }
}

TEST(MinimumSlicePerimeter, MoreSlicesNeverFindMore)
{
  const TriangleMesh mesh = MakeEgg(3);
  const SliceField few = MSPOf(mesh, 6);
  const SliceField many = MSPOf(mesh, 24);
  int smaller = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_LE(many.Perimeter[v], few.Perimeter[v] * (1.0 + 1e-12)) << v;
    smaller += many.Perimeter[v] < few.Perimeter[v] * (1.0 - 1e-6);
  }
  EXPECT_GT(smaller, mesh.NumberOfVertices() / 10);
}

TEST(MinimumSlicePerimeter, TurnsAndScalesWithTheMesh)
{
  const TriangleMesh mesh = MakeEgg(3);
  const SliceField field = MSPOf(mesh);
  const Eigen::Vector3d axis(1.0, -2.0, 0.5);
  const Eigen::Vector3d offset(30.0, -7.0, 11.0);
  const double factor = 1e-3;
  const TriangleMesh moved = Translated(Scaled(Rotated(mesh, axis, 1.1), factor), offset);
  const SliceField movedField = MSPOf(moved);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.1, axis.normalized()).toRotationMatrix();
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_NEAR(movedField.Perimeter[v], factor * field.Perimeter[v], 1e-8 * factor) << v;
    const Eigen::Vector3d center = factor * (rotation * field.Center[v]) + offset;
    ASSERT_LT((movedField.Center[v] - center).norm(), 1e-6 * factor) << v;
  }
}

TEST(MinimumSlicePerimeter, DoesNotDependOnTheOrderOfVertices)
{
  const TriangleMesh mesh = MakeEgg(3);
  const SliceField field = MSPOf(mesh);
  const PermutedMesh permuted = Permuted(mesh, 7);
  const SliceField other = MSPOf(permuted.Mesh);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const int old = permuted.OldVertex[v];
    ASSERT_NEAR(other.Perimeter[v], field.Perimeter[old], 1e-9) << v;
    ASSERT_LT((other.Center[v] - field.Center[old]).norm(), 1e-7) << v;
  }
}

TEST(MinimumSlicePerimeter, OpenCylinderKeepsClosedSlicesClosed)
{
  const double radius = 1.0;
  const TriangleMesh mesh = Without(MakeCylinder(radius, 10.0, 36, 60),
    [](const TriangleMesh& m, int t) { return m.Centroid(t).z() > 5.0 - 1e-9; });
  const SliceField field = MSPOf(mesh);
  ExpectFinite(mesh, field);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    // Up to the rim itself but for the ring on it, whose slice across has nowhere to go.
    if (mesh.Outgoing[v] >= 0 && mesh.Points[v].z() > -3.0 && mesh.Points[v].z() < 4.9)
    {
      ASSERT_EQ(field.Valid[v], 1) << v;
      ASSERT_NEAR(field.Perimeter[v], 2.0 * Pi * radius, 0.05) << v;
    }
  }
}

TEST(MinimumSlicePerimeter, ClosesOpenSlicesByTheirChordAndSaysSo)
{
  // A tube slit along its whole length: no slice around it closes, and the chord over the slit is
  // what the missing strip was.
  const double radius = 1.0;
  const TriangleMesh mesh = Without(MakeCylinder(radius, 10.0, 36, 60),
    [](const TriangleMesh& m, int t)
    {
      const Eigen::Vector3d c = m.Centroid(t);
      return std::abs(c.z()) > 5.0 - 1e-9 || std::abs(std::atan2(c.y(), c.x())) < 2.0 * Pi / 36;
    });
  const SliceField field = MSPOf(mesh);
  ExpectFinite(mesh, field);
  int checked = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_EQ(field.Valid[v], 0) << v;
    const Eigen::Vector3d& p = mesh.Points[v];
    if (mesh.Outgoing[v] >= 0 && std::abs(p.z()) < 2.0 && p.x() < 0.0)
    {
      ++checked;
      EXPECT_LT(field.Perimeter[v], 2.0 * Pi * radius) << v;
      EXPECT_GT(field.Perimeter[v], 2.0 * Pi * radius * 0.8) << v;
    }
  }
  EXPECT_GT(checked, 100);
}

TEST(MinimumSlicePerimeter, FillsVerticesWithoutAreaAndLeavesUnusedPoints)
{
  // A vertex whose triangles have all collapsed has no normal and no slice.
  TriangleMesh mesh = MakeEgg(3);
  const int collapsed = 5;
  std::set<int> ring;
  mesh.ForEachNeighbor(collapsed, [&](int n) { ring.insert(n); });
  const Eigen::Vector3d place = mesh.Points[collapsed];
  for (int n : ring)
  {
    mesh.Points[n] = place;
  }
  mesh.Points.push_back({ 9.0, 9.0, 9.0 });
  mesh.BuildConnectivity();
  const SliceField field = MSPOf(mesh);
  ExpectFinite(mesh, field);
  EXPECT_EQ(field.Valid[collapsed], 0);
  EXPECT_GT(field.Perimeter[collapsed], 0.0);
  EXPECT_EQ(field.Perimeter.back(), 0.0);
  EXPECT_EQ(field.Center.back(), mesh.Points.back());
  EXPECT_EQ(field.Valid.back(), 0);
}

TEST(MinimumSlicePerimeter, StandsTheSmallestMeshes)
{
  TriangleMesh triangle;
  triangle.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  triangle.Triangles = { { 0, 1, 2 } };
  triangle.BuildConnectivity();
  ExpectFinite(triangle, MSPOf(triangle));

  TriangleMesh collapsed = triangle;
  collapsed.Points[1] = collapsed.Points[2] = collapsed.Points[0];
  const SliceField field = MSPOf(collapsed);
  ExpectFinite(collapsed, field);
  EXPECT_EQ(field.Perimeter, std::vector<double>(3, 0.0));

  const TriangleMesh octahedron = MakeSphere(1.0, 0);
  const SliceField closed = MSPOf(octahedron);
  ExpectFinite(octahedron, closed);
  EXPECT_EQ(closed.Valid, std::vector<unsigned char>(6, 1));
}

TEST(MinimumSlicePerimeter, StopsWhenAsked)
{
  SliceField field;
  EXPECT_FALSE(
    ComputeMinimumSlicePerimeter(MakeSphere(1.0, 2), 12, field, [](double) { return false; }));
}
