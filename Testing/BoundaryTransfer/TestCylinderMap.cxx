// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryTransfer.h"
#include "CylinderMap.h"
#include "TubeShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace marrow;
using namespace marrow::test;

TEST(CylinderMap, IsHeightAndAngleOnACylinder)
{
  const Tube tube = MakeTube({});
  const TriangleMesh& mesh = tube.Analyzed.Mesh;
  PathFinder paths(mesh);
  FittingPlane plane;
  plane.Normal = Eigen::Vector3d::UnitZ();
  plane.Radius = 0.5;
  std::vector<Eigen::Vector3d> rays;
  for (int k = 0; k < 16; ++k)
  {
    rays.push_back(0.5 * Eigen::Vector3d(std::cos(k * Pi / 8.0), std::sin(k * Pi / 8.0), 0.0));
  }
  auto region =
    BuildCoveringRegion(mesh, paths, plane, SeedsOfRays(mesh, plane.Center, rays), 0.5, {});
  ASSERT_TRUE(region);
  const auto map = CylinderMap::Build(paths, mesh, *region, plane.Center, plane.Normal);
  ASSERT_TRUE(map);
  double low = 1e9;
  double high = -1e9;
  for (int v : region->Rims[0])
  {
    low = std::min(low, mesh.Points[v].z());
    EXPECT_EQ(map->OfVertex(v).y(), 0.0);
  }
  for (int v : region->Rims[1])
  {
    high = std::max(high, mesh.Points[v].z());
  }
  ASSERT_LT(low, -0.4);
  ASSERT_GT(high, 0.4);
  double offset = 2.0;
  std::set<int> vertices;
  for (int t : region->Triangles)
  {
    vertices.insert(mesh.Triangles[t].begin(), mesh.Triangles[t].end());
  }
  for (int v : vertices)
  {
    const Eigen::Vector3d& p = mesh.Points[v];
    const Eigen::Vector2d uv = map->OfVertex(v);
    EXPECT_NEAR(uv.y(), (p.z() - low) / (high - low), 0.02);
    double difference = uv.x() - std::atan2(p.y(), p.x()) / (2.0 * Pi);
    difference -= std::floor(difference);
    offset = offset > 1.0 ? difference : offset;
    double change = difference - offset;
    change -= std::round(change);
    EXPECT_NEAR(change, 0.0, 0.01);
    // There and back.
    EXPECT_LT((map->PointAt(uv) - p).norm(), 1e-6);
  }
  // A curve at v = 1/2 parts the region's triangles by height.
  std::vector<Eigen::Vector2d> curve;
  for (int k = 0; k < 50; ++k)
  {
    curve.push_back({ k / 50.0, 0.5 });
  }
  for (const auto& [triangle, side] : SidesOfCurve(*map, curve))
  {
    const double z = mesh.Centroid(triangle).z() - 0.5 * (low + high);
    if (std::abs(z) > 0.02)
    {
      EXPECT_EQ(side, z > 0.0 ? 1 : 0);
    }
  }
}
