// SPDX-License-Identifier: BSD-3-Clause
// What has no partner in the correspondence is found where it lies.
#include "LeftoverPlaces.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

using namespace marrow;

namespace
{
/// A row of matched nodes along x, another along y, and a part without partner that stands up along z.
/// The target is the source turned, half as large and moved.
struct MatchedRows
{
  AnalyzedMesh Source;
  AnalyzedMesh Target;
  std::vector<SkeletonMap::Place> Places;
  std::vector<bool> IsMatched;
  Eigen::Affine3d ToSource;
  static constexpr int Row = 10;

  explicit MatchedRows(bool onOneLine = false)
    : ToSource(Eigen::Translation3d(3.0, -1.0, 2.0) *
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(2.0))
  {
    this->Source.Skeleton.Graph = SkeletonGraph(3 * Row);
    this->Target.Skeleton.Graph = SkeletonGraph(3 * Row);
    this->Source.Skeleton.MeshDiagonal = 20.0;
    this->Target.Skeleton.MeshDiagonal = 10.0;
    for (int n = 0; n < 3 * Row; ++n)
    {
      const int axis = onOneLine && n / Row == 1 ? 0 : n / Row;
      const Eigen::Vector3d t =
        (n % Row + (axis == n / Row ? 0 : Row)) * 0.5 * Eigen::Vector3d::Unit(axis);
      this->Target.Skeleton.Graph[n].Position = t;
      this->Source.Skeleton.Graph[n].Position = this->ToSource * t;
      this->Source.Skeleton.Graph[n].Radius = 0.1 + n;
      if (n % Row > 0)
      {
        boost::add_edge(n - 1, n, this->Source.Skeleton.Graph);
        boost::add_edge(n - 1, n, this->Target.Skeleton.Graph);
      }
      SkeletonMap::Place place;
      place.Known = true;
      place.Matched = n < 2 * Row;
      place.SourceNode = place.Matched ? n : 0;
      place.Transform = this->ToSource.matrix().topRows<3>();
      this->Places.push_back(place);
      this->IsMatched.push_back(place.Matched);
    }
  }
  void Run() { PlaceLeftovers(this->Source, this->Target, this->Places, this->IsMatched); }
};
}

TEST(LeftoverPlaces, TakesThePlaceWhereItLies)
{
  MatchedRows rows;
  rows.Run();
  for (int n = 2 * rows.Row; n < 3 * rows.Row; ++n)
  {
    EXPECT_TRUE(rows.Places[n].IsLeftover);
    EXPECT_FALSE(rows.Places[n].Matched);
    EXPECT_EQ(n, rows.Places[n].SourceNode);
    EXPECT_DOUBLE_EQ(0.1 + n, rows.Places[n].Radius);
    EXPECT_TRUE(rows.Places[n].Transform.isApprox(rows.ToSource.matrix().topRows<3>(), 1e-9));
    EXPECT_TRUE(rows.IsMatched[n]);
  }
}

TEST(LeftoverPlaces, WhatLiesElsewhereIsLeftAlone)
{
  MatchedRows rows;
  // The source's part stands on the other side; the nodes at its root are still near.
  for (int n = 2 * rows.Row; n < 3 * rows.Row; ++n)
  {
    const Eigen::Vector3d other = -rows.Target.Skeleton.Graph[n].Position;
    rows.Source.Skeleton.Graph[n].Position = rows.ToSource * other;
  }
  rows.Run();
  EXPECT_FALSE(rows.Places[3 * rows.Row - 1].IsLeftover);
  EXPECT_EQ(0, rows.Places[3 * rows.Row - 1].SourceNode);
  EXPECT_FALSE(rows.IsMatched[3 * rows.Row - 1]);
}

TEST(LeftoverPlaces, AMatchedLineAloneDoesNotSayWhichWayIsUp)
{
  MatchedRows rows(true);
  rows.Run();
  for (const auto& place : rows.Places)
  {
    EXPECT_FALSE(place.IsLeftover);
  }
}

TEST(LeftoverPlaces, MatchedPlacesStayAsTheyAre)
{
  MatchedRows rows;
  // A source node without partner right beside a matched one is not for that.
  rows.Source.Skeleton.Graph[2 * rows.Row].Position = rows.Source.Skeleton.Graph[3].Position;
  rows.Run();
  EXPECT_EQ(3, rows.Places[3].SourceNode);
  EXPECT_FALSE(rows.Places[3].IsLeftover);
}
