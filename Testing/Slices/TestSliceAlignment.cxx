// SPDX-License-Identifier: BSD-3-Clause
#include "RevolutionShapes.h"
#include "SliceAlignment.h"
#include "TestMeshes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

using namespace marrow;
using namespace marrow::test;

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
