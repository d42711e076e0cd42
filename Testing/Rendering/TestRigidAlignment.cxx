// SPDX-License-Identifier: BSD-3-Clause
#include "RigidAlignment.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

TEST(RigidAlignment, FindsTheRotationAndNeverAReflection)
{
  const marrow::LabelCentroids reference = { { 1, { 0, 0, 0 } }, { 2, { 1, 0, 0 } },
    { 3, { 0, 2, 0 } }, { 5, { 0, 0, 3 } } };
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  marrow::LabelCentroids turned = { { 9, { 100, 0, 0 } } }; // shared by nobody
  marrow::LabelCentroids mirrored;
  for (const auto& [label, centroid] : reference)
  {
    turned[label] = 4.0 * (rotation * centroid) + Eigen::Vector3d(5, 6, 7);
    mirrored[label] = Eigen::Vector3d(-centroid.x(), centroid.y(), centroid.z());
  }
  EXPECT_TRUE(marrow::RotationTo(reference, turned).isApprox(rotation.transpose(), 1e-12));
  EXPECT_NEAR(marrow::RotationTo(reference, mirrored).determinant(), 1.0, 1e-12);
  const marrow::LabelCentroids two = { { 1, { 0, 0, 0 } }, { 2, { 0, 1, 0 } } };
  EXPECT_TRUE(marrow::RotationTo(reference, two).isIdentity());
}

TEST(RigidAlignment, TheBroadSideIsPerpendicularToUpAndToTheLongAxis)
{
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 100; ++i)
  {
    points.emplace_back(0.1 * (i % 3), 0.5 * (i % 7), 0.2 * i);
  }
  EXPECT_GT(marrow::BroadSide(points, Eigen::Vector3d::UnitY()).x(), 0.999);
}
