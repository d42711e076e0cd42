// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of revolution with segments along the axis, carried to other proportions.
#include "SliceAlignment.h"
#include "TransferTestData.h"

#include <Eigen/Geometry>

#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// A profile from the foot up, and which segment it is from there on.
struct Ring
{
  double Height;
  double Radius;
  int Segment;
};

struct Labelled
{
  TriangleMesh Mesh;
  std::vector<int> Labels;
};

enum Segment
{
  Base,
  Belly,
  Neck,
  Lip,
  Handle
};

/// Straight between the rings, closed by a point at either end. Triangles are no longer than they are
/// wide, so that each is of one segment.
Labelled Turn(const std::vector<Ring>& profile)
{
  constexpr int around = 48;
  constexpr double step = 0.05;
  Labelled result;
  std::vector<int> segmentOfRing; // what is above it
  const auto addRing = [&](double height, double radius, int segment)
  {
    for (int k = 0; k < around; ++k)
    {
      const double angle = 2.0 * Pi * k / around;
      result.Mesh.Points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
    segmentOfRing.push_back(segment);
  };
  const auto addTriangle = [&](int a, int b, int c, int segment)
  {
    result.Mesh.Triangles.push_back({ a, b, c });
    result.Labels.push_back(segment);
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
  {
    const Ring& a = profile[i];
    const Ring& b = profile[i + 1];
    const int steps =
      std::max(1, static_cast<int>(std::hypot(b.Height - a.Height, b.Radius - a.Radius) / step));
    for (int s = 0; s < steps; ++s)
    {
      const double t = static_cast<double>(s) / steps;
      addRing((1.0 - t) * a.Height + t * b.Height, (1.0 - t) * a.Radius + t * b.Radius, a.Segment);
    }
  }
  addRing(profile.back().Height, profile.back().Radius, profile.back().Segment);
  const int rings = static_cast<int>(segmentOfRing.size());
  for (int r = 0; r + 1 < rings; ++r)
  {
    for (int k = 0; k < around; ++k)
    {
      const int a = r * around + k;
      const int b = r * around + (k + 1) % around;
      addTriangle(a, b, b + around, segmentOfRing[r]);
      addTriangle(a, b + around, a + around, segmentOfRing[r]);
    }
  }
  const int bottom = result.Mesh.NumberOfVertices();
  result.Mesh.Points.emplace_back(0.0, 0.0, profile.front().Height);
  result.Mesh.Points.emplace_back(0.0, 0.0, profile.back().Height);
  for (int k = 0; k < around; ++k)
  {
    const int next = (k + 1) % around;
    const int top = (rings - 1) * around;
    addTriangle(bottom, next, k, profile.front().Segment);
    addTriangle(bottom + 1, top + k, top + next, profile[profile.size() - 2].Segment);
  }
  result.Mesh.BuildConnectivity();
  return result;
}

Labelled Jug()
{
  return Turn({ { 0.0, 0.5, Base }, { 0.2, 0.45, Base }, { 0.25, 0.4, Belly }, { 0.8, 0.9, Belly },
    { 1.3, 0.8, Belly }, { 1.7, 0.3, Neck }, { 2.4, 0.28, Lip }, { 2.6, 0.5, Lip } });
}

/// Low and wide, with a long foot and a thicker neck.
Labelled Bowl()
{
  return Turn({ { 0.0, 0.8, Base }, { 0.4, 0.7, Base }, { 0.45, 0.6, Belly }, { 0.8, 1.5, Belly },
    { 1.2, 1.3, Belly }, { 1.5, 0.6, Neck }, { 1.9, 0.55, Lip }, { 2.0, 0.8, Lip } });
}

/// Half a ring beside the axis that touches the wall, as a second part of the same mesh.
void AddHandle(Labelled& jug, double radius, double height, double size)
{
  TriangleMesh ring = MakeTorus(size, 0.15 * size, 40, 12);
  ring = Rotated(ring, Eigen::Vector3d::UnitX(), 0.5 * Pi);
  const int first = jug.Mesh.NumberOfVertices();
  for (const Eigen::Vector3d& point : ring.Points)
  {
    jug.Mesh.Points.push_back(point + Eigen::Vector3d(radius, 0.0, height));
  }
  for (const auto& [a, b, c] : ring.Triangles)
  {
    jug.Mesh.Triangles.push_back({ first + a, first + b, first + c });
    jug.Labels.push_back(Handle);
  }
  jug.Mesh.BuildConnectivity();
}

Labelled Moved(Labelled shape)
{
  shape.Mesh =
    Translated(Scaled(Rotated(shape.Mesh, Eigen::Vector3d(1.0, 2.0, 0.5).normalized(), 2.1), 3.7),
      { 5.0, -2.0, 11.0 });
  shape.Mesh.BuildConnectivity();
  return shape;
}

Data ToData(const Labelled& shape)
{
  Data data = ToPolyData(shape.Mesh);
  SetIntArray(data->GetCellData(), names::SegmentId, shape.Labels);
  return data;
}

/// The share of the target's area with the segment that it was made with, by slices.
double Accuracy(const Labelled& source, const Labelled& target)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, ToData(source));
  transfer->SetInputData(1, ToData(target));
  transfer->Update();
  auto* matchedBy = vtkStringArray::SafeDownCast(
    transfer->GetOutput()->GetFieldData()->GetAbstractArray(names::MatchedBy));
  EXPECT_TRUE(matchedBy && matchedBy->GetNumberOfValues() == 1);
  EXPECT_EQ(matchedBy->GetValue(0), "slices");
  vtkDataArray* labels = transfer->GetOutput()->GetCellData()->GetArray(names::SegmentId);
  double same = 0.0;
  double total = 0.0;
  for (int t = 0; t < target.Mesh.NumberOfTriangles(); ++t)
  {
    total += target.Mesh.Area(t);
    same += labels->GetTuple1(t) == target.Labels[t] ? target.Mesh.Area(t) : 0.0;
  }
  return same / total;
}
}

TEST(RevolutionAxis, IsFoundWhereverTheShapeLies)
{
  const RevolutionAxis axis = FindRevolutionAxis(Moved(Jug()).Mesh);
  const Eigen::AngleAxisd rotation(2.1, Eigen::Vector3d(1.0, 2.0, 0.5).normalized());
  const Eigen::Vector3d expected = rotation * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(std::abs(axis.Direction.dot(expected)), 1.0, 1e-6);
  const Eigen::Vector3d away = axis.Point - Eigen::Vector3d(5.0, -2.0, 11.0);
  EXPECT_NEAR((away - away.dot(expected) * expected).norm(), 0.0, 1e-3);
}

TEST(SliceChain, HasTheProfile)
{
  const auto slices = FindSlices(Jug().Mesh);
  ASSERT_TRUE(slices);
  EXPECT_GT(slices->GetRoundness(), 0.95);
  double widest = 0.0;
  for (const SliceChain::Slice& slice : slices->GetSlices())
  {
    widest = std::max(widest, slice.Radius);
  }
  EXPECT_NEAR(widest, 0.9, 0.02);
}

TEST(SliceChain, AHandleStandsOffTheWall)
{
  Labelled jug = Jug();
  AddHandle(jug, 1.0, 1.6, 0.5);
  const auto slices = FindSlices(jug.Mesh);
  ASSERT_TRUE(slices);
  EXPECT_TRUE(slices->IsAppended({ 1.5, 0.0, 1.6 }));
  EXPECT_FALSE(slices->IsAppended({ 0.0, 0.9, 0.8 }));
  EXPECT_FALSE(slices->IsAppended({ -0.3, 0.0, 2.0 }));
}

TEST(SliceChain, OtherShapesAreNotOfRevolution)
{
  TriangleMesh box = MakeCylinder(1.0, 3.0, 4, 20);
  EXPECT_FALSE(FindSlices(box));
  TriangleMesh creature;
  ToTriangleMesh(MakeCreature(vtkCreatureSource::QUADRUPED, CreatureOptions()).Mesh, creature);
  EXPECT_FALSE(FindSlices(creature));
}

TEST(SliceAlignment, ToldTheWayRoundByTheProfile)
{
  const auto jug = FindSlices(Jug().Mesh);
  const auto bowl = FindSlices(Bowl().Mesh);
  ASSERT_TRUE(jug && bowl);
  // Both axes point up or down, as it came out.
  const bool isTurned = jug->GetFrame()(2, 2) * bowl->GetFrame()(2, 2) < 0.0;
  const SliceAlignment right(*jug, *bowl, isTurned);
  const SliceAlignment wrong(*jug, *bowl, !isTurned);
  EXPECT_LT(right.GetCost(), 0.8 * wrong.GetCost());
  EXPECT_LT(right.GetCost(), 0.5);
  // The foot, the widest place and the middle of the neck.
  EXPECT_NEAR(right.ToSource({ 0.75, 0.0, 0.2 }).z(), 0.1, 0.1);
  EXPECT_NEAR(right.ToSource({ 1.5, 0.0, 0.8 }).z(), 0.8, 0.1);
  EXPECT_NEAR(right.ToSource({ 0.0, 0.575, 1.7 }).z(), 2.05, 0.35);
  EXPECT_NEAR(right.ToSource({ 1.5, 0.0, 0.8 }).head<2>().norm(), 0.9, 0.03);
  EXPECT_NEAR(right.GetRotation().determinant(), 1.0, 1e-9);
  EXPECT_NEAR(wrong.GetRotation().determinant(), 1.0, 1e-9);
}

TEST(SliceAlignment, OfAShapeWithItselfCostsNothing)
{
  const auto slices = FindSlices(Jug().Mesh);
  ASSERT_TRUE(slices);
  const SliceAlignment same(*slices, *slices, false);
  EXPECT_NEAR(same.GetCost(), 0.0, 1e-12);
  const Eigen::Vector3d point(0.2, -0.3, 1.234);
  EXPECT_NEAR((same.ToSource(point) - point).norm(), 0.0, 1e-9);
}

TEST(SliceTransfer, FootBellyNeckAndLipGoToOtherProportions)
{
  EXPECT_GT(Accuracy(Jug(), Bowl()), 0.95);
  EXPECT_GT(Accuracy(Bowl(), Jug()), 0.95);
}

TEST(SliceTransfer, AHandleGoesToAHandle)
{
  Labelled jug = Jug();
  AddHandle(jug, 1.0, 1.6, 0.5);
  Labelled bowl = Bowl();
  AddHandle(bowl, 1.3, 1.4, 0.5);
  bowl.Mesh = Rotated(bowl.Mesh, Eigen::Vector3d::UnitZ(), 1.9);
  bowl.Mesh.BuildConnectivity();
  EXPECT_GT(Accuracy(jug, bowl), 0.93);
}

TEST(SliceTransfer, StrictBoundariesKnowSkeletonsAlone)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, ToData(Jug()));
  transfer->SetInputData(1, ToData(Bowl()));
  transfer->StrictBoundariesOn();
  transfer->Update();
  auto* matchedBy = vtkStringArray::SafeDownCast(
    transfer->GetOutput()->GetFieldData()->GetAbstractArray(names::MatchedBy));
  ASSERT_TRUE(matchedBy);
  EXPECT_NE(matchedBy->GetValue(0), "slices");
}

TEST(SliceTransfer, UpsideDownAndScaledItIsTheSame)
{
  EXPECT_GT(Accuracy(Jug(), Moved(Bowl())), 0.95);
}
