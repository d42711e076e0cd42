// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "MeshCheck.h"
#include "SkeletonResult.h"
#include "WindingNumber.h"

#include <gtest/gtest.h>

#include <vtkMSPSkeleton.h>
#include <vtkSMPTools.h>

#include <cmath>
#include <set>

namespace
{
using namespace marrow;

test::SkeletonResult Skeletonize(vtkPolyData* mesh, double finestArea = -1.0)
{
  vtkNew<vtkMSPSkeleton> filter;
  if (finestArea >= 0.0)
  {
    filter->SetFinestArea(finestArea);
  }
  filter->SetInputData(mesh);
  return test::SkeletonResult(filter.Get());
}

TEST(MSPSkeleton, CylinderGivesItsAxis)
{
  const double length = 12.0;
  test::ExpectCylinderAxis(
    Skeletonize(test::ToPolyData(test::MakeCylinder(1.0, length, 40, 100))), length, 0.85, 0.05);
}

TEST(MSPSkeleton, TorusGivesOneClosedBranch)
{
  test::ExpectOneClosedBranch(
    Skeletonize(test::ToPolyData(test::MakeTorus(3.0, 1.0, 80, 30))), 3.0);
}

struct Expected
{
  int Shape;
  int Terminals;
  int Loops;
};

class Creatures : public testing::TestWithParam<Expected>
{
};

TEST_P(Creatures, TerminalsAreTheExtremities)
{
  for (int seed = 1; seed <= 4; ++seed)
  {
    test::CreatureOptions options;
    options.Seed = seed;
    options.Pose = seed == 1 ? 0.0 : 0.7;
    options.Proportion = seed == 1 ? 0.0 : 0.7;
    options.Faces = seed % 2 == 0 ? 5000 : 12000;
    const test::Creature creature = test::MakeCreature(GetParam().Shape, options);
    const test::SkeletonResult result = Skeletonize(creature.Mesh);
    EXPECT_EQ(result.Terminals, GetParam().Terminals) << "seed " << seed;
    EXPECT_EQ(result.Skeleton.NumberOfLoops(), GetParam().Loops) << "seed " << seed;
    EXPECT_EQ(result.Skeleton.NumberOfComponents(), 1) << "seed " << seed;

    // Each terminal has its own extremity: it is close to one known terminal and to no other's.
    marrow::Skeleton known;
    marrow::SkeletonGraph graph;
    std::set<int> found;
    const vtkIdType numberOfKnown = creature.Skeleton->GetNumberOfPoints();
    std::vector<int> type;
    ASSERT_TRUE(GetArray(
      creature.Skeleton->GetPointData(), names::NodeType, static_cast<int>(numberOfKnown), type));
    for (int n = 0; n < result.Skeleton.NumberOfNodes(); ++n)
    {
      if (result.Skeleton.TypeOf(n) != NodeType::Terminal)
      {
        continue;
      }
      int nearest = -1;
      double distance = 0.0;
      for (vtkIdType k = 0; k < numberOfKnown; ++k)
      {
        Eigen::Vector3d point;
        creature.Skeleton->GetPoint(k, point.data());
        const double d = (point - result.Skeleton.Graph[n].Position).norm();
        if (type[k] == 1 && (nearest < 0 || d < distance))
        {
          nearest = static_cast<int>(k);
          distance = d;
        }
      }
      found.insert(nearest);
      EXPECT_LT(distance, 0.08 * result.Skeleton.MeshDiagonal) << "seed " << seed;
    }
    EXPECT_EQ(static_cast<int>(found.size()), GetParam().Terminals) << "seed " << seed;
  }
}

TEST_P(Creatures, NodesAreInsideAndPatchesArePartsOfTheMesh)
{
  const test::Creature creature = test::MakeCreature(GetParam().Shape);
  const test::SkeletonResult result = Skeletonize(creature.Mesh);
  TriangleMesh mesh;
  ASSERT_EQ(ToTriangleMesh(creature.Mesh, mesh), "");

  std::vector<int> owner(mesh.Points.size(), -1);
  int inside = 0;
  for (int n = 0; n < result.Skeleton.NumberOfNodes(); ++n)
  {
    const SkeletonNode& node = result.Skeleton.Graph[n];
    inside += WindingNumber(mesh, node.Position) > 0.5;
    for (const int v : node.Vertices)
    {
      owner[v] = n;
    }
  }
  EXPECT_EQ(inside, result.Skeleton.NumberOfNodes());

  // Every vertex has a node, and each φ hangs together on the mesh.
  std::vector<char> seen(mesh.Points.size(), 0);
  std::vector<int> pieces(result.Skeleton.NumberOfNodes(), 0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    ASSERT_GE(owner[v], 0) << "vertex " << v;
    if (seen[v])
    {
      continue;
    }
    ++pieces[owner[v]];
    std::vector<int> stack(1, v);
    seen[v] = 1;
    while (!stack.empty())
    {
      const int at = stack.back();
      stack.pop_back();
      mesh.ForEachNeighbor(at,
        [&](int neighbor)
        {
          if (!seen[neighbor] && owner[neighbor] == owner[at])
          {
            seen[neighbor] = 1;
            stack.push_back(neighbor);
          }
        });
    }
  }
  for (int n = 0; n < result.Skeleton.NumberOfNodes(); ++n)
  {
    EXPECT_LE(pieces[n], 1) << "node " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(MSPSkeleton, Creatures,
  testing::Values(Expected{ vtkCreatureSource::BIPED, 5, 0 },
    Expected{ vtkCreatureSource::QUADRUPED, 6, 0 }, Expected{ vtkCreatureSource::OCTOPUS, 9, 0 },
    Expected{ vtkCreatureSource::CHAIR, 4, 3 }, Expected{ vtkCreatureSource::SNAKE, 2, 0 },
    Expected{ vtkCreatureSource::CAPSULE, 2, 0 }),
  [](const auto& instance) { return "Shape" + std::to_string(instance.param.Shape); });

TEST(MSPSkeleton, TheSameOnAnyNumberOfThreads)
{
  const test::Creature creature = test::MakeCreature(vtkCreatureSource::QUADRUPED);
  std::vector<vtkSmartPointer<vtkPolyData>> results;
  for (const int threads : { 1, 2, 4 })
  {
    vtkSMPTools::Initialize(threads);
    results.push_back(Skeletonize(creature.Mesh).PolyData);
  }
  vtkSMPTools::Initialize();
  for (const auto& other : results)
  {
    ASSERT_EQ(other->GetNumberOfPoints(), results[0]->GetNumberOfPoints());
    for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        ASSERT_EQ(other->GetPoint(i)[k], results[0]->GetPoint(i)[k]);
      }
    }
  }
}

TEST(MSPSkeleton, TurnsScalesAndDoesNotDependOnTheOrder)
{
  const test::Creature creature = test::MakeCreature(vtkCreatureSource::QUADRUPED);
  const test::SkeletonResult reference = Skeletonize(creature.Mesh);
  const Eigen::AngleAxisd turn(1.1, Eigen::Vector3d(1.0, 2.0, -0.5).normalized());
  const test::SkeletonResult turned = Skeletonize(test::Transformed(
    creature.Mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return 7.0 * (turn * p); }));
  const test::SkeletonResult permuted = Skeletonize(test::Permuted(creature.Mesh, 5).Mesh);
  for (const test::SkeletonResult* other : { &turned, &permuted })
  {
    EXPECT_EQ(other->Terminals, reference.Terminals);
    EXPECT_EQ(other->Skeleton.NumberOfBranches(), reference.Skeleton.NumberOfBranches());
    const double scale = other == &turned ? 7.0 : 1.0;
    EXPECT_NEAR(other->Skeleton.TotalLength() / scale, reference.Skeleton.TotalLength(),
      0.03 * reference.Skeleton.TotalLength());
  }
}

TEST(MSPSkeleton, NoiseGrowsNoBranches)
{
  test::CreatureOptions options;
  options.Noise = 0.004;
  options.Faces = 10000;
  EXPECT_EQ(
    Skeletonize(test::MakeCreature(vtkCreatureSource::QUADRUPED, options).Mesh).Terminals, 6);
}

TEST(MSPSkeleton, FinestAreaDecidesWhatIsALimb)
{
  const test::Creature creature = test::MakeCreature(vtkCreatureSource::QUADRUPED);
  // Nothing is worth a branch: only the two ends of the longest path stay.
  EXPECT_LE(Skeletonize(creature.Mesh, 1.0).Terminals, 2);
  EXPECT_GE(Skeletonize(creature.Mesh, 0.0001).Terminals, 6);
}

/// A cylinder of radius 1 along z, with a limb of radius 0.3 and length 3 along x, pulled out of the
/// disc of radius 0.9 around its middle. Sets `onLimb` of the vertices that stand out.
TriangleMesh MakeCylinderWithLimb(double length, std::vector<char>& onLimb)
{
  constexpr double Disc = 0.9;
  constexpr double LimbRadius = 0.3;
  constexpr double LimbLength = 3.0;
  TriangleMesh mesh = test::MakeCylinder(1.0, length, 80, 150);
  onLimb.assign(mesh.Points.size(), 0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    Eigen::Vector3d& p = mesh.Points[v];
    const Eigen::Vector2d arc(std::atan2(p.y(), p.x()), p.z());
    const double t = arc.norm() / Disc;
    if (t >= 1.0 || std::abs(p.head<2>().norm() - 1.0) > 1e-9)
    {
      continue;
    }
    // The inner fifth is the cap, the outer fifth what is left of the disc, the wall in between.
    const double height = LimbLength * std::clamp((0.8 - t) / 0.6, 0.0, 1.0);
    const double radius = t < 0.2 ? LimbRadius * t / 0.2
                                  : LimbRadius + (Disc - LimbRadius) * std::max(0.0, t - 0.8) / 0.2;
    const Eigen::Vector2d moved = t > 0.0 ? Eigen::Vector2d(arc.normalized() * radius) : arc;
    p = Eigen::Vector3d(std::cos(moved.x()) + height, std::sin(moved.x()), moved.y());
    onLimb[v] = height > 0.5;
  }
  return mesh;
}

TEST(MSPSkeleton, APrunedLimbDoesNotMoveTheLineThatIsLeft)
{
  const double length = 14.0;
  std::vector<char> onLimb;
  const TriangleMesh mesh = MakeCylinderWithLimb(length, onLimb);
  const auto polyData = test::WithMeasures(test::ToPolyData(mesh));
  ASSERT_EQ(Skeletonize(polyData).Terminals, 3);

  const test::SkeletonResult pruned = Skeletonize(polyData, 0.2);
  ASSERT_EQ(pruned.Terminals, 2);
  int foot = -1;
  double farthest = 0.0;
  for (int n = 0; n < pruned.Skeleton.NumberOfNodes(); ++n)
  {
    const SkeletonNode& node = pruned.Skeleton.Graph[n];
    if (std::abs(node.Position.z()) < length / 2.0 - 1.5)
    {
      farthest = std::max(farthest, node.Position.head<2>().norm());
    }
    for (const int v : node.Vertices)
    {
      // All of the limb belongs to one node, the one where it hung.
      if (onLimb[v])
      {
        EXPECT_TRUE(foot < 0 || foot == n) << "vertex " << v;
        foot = n;
      }
    }
  }
  EXPECT_LT(farthest, 0.1);
  ASSERT_GE(foot, 0);
  // No further from the limb's axis than two nodes.
  EXPECT_LT(std::abs(pruned.Skeleton.Graph[foot].Position.z()), 2.0 * 0.012 * length);
  EXPECT_LT(pruned.Skeleton.TotalLength(), 1.01 * length);
}

TEST(MSPSkeleton, AnOpenMeshIsTreatedLikeTheClosedOne)
{
  TriangleMesh mesh = test::MakeCylinder(1.0, 12.0, 40, 100);
  // Take one cap off.
  TriangleMesh open;
  open.Points = mesh.Points;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (mesh.Centroid(t).z() < 6.0 - 1e-9)
    {
      open.Triangles.push_back(mesh.Triangles[t]);
    }
  }
  const test::SkeletonResult result = Skeletonize(test::ToPolyData(open));
  EXPECT_EQ(result.Terminals, 2);
  EXPECT_EQ(result.Skeleton.NumberOfLoops(), 0);
  EXPECT_GT(result.Skeleton.TotalLength(), 0.85 * 12.0);
}

TEST(MSPSkeleton, ComponentsGiveSkeletonsOfTheirOwn)
{
  const test::SkeletonResult result = Skeletonize(test::MakeTwoCylinders());
  EXPECT_EQ(result.Skeleton.NumberOfComponents(), 2);
  EXPECT_EQ(result.Terminals, 4);
}

TEST(MSPSkeleton, UsesTheMeasuresThatAreThere)
{
  const auto mesh = test::WithMeasures(test::ToPolyData(test::MakeCylinder(1.0, 10.0, 24, 60)));
  mesh->GetPointData()->GetArray(names::AGD)->Fill(0.625);
  test::ExpectAGD(Skeletonize(mesh), 0.625);
}

TEST(MSPSkeleton, KeepsTheUsersArraysAndNumbers)
{
  const test::Creature creature = test::MakeCreature(vtkCreatureSource::SNAKE);
  test::ExpectKept(creature.Mesh, Skeletonize(creature.Mesh));
}

/// The centroids of so few triangles are at one place, and tell nothing of their size.
TEST(MSPSkeleton, OneTriangleHasTheSameSkeletonInAnyUnit)
{
  TriangleMesh once;
  once.Points = { { -2.0, 1.0, 1.0 }, { 2.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 } };
  once.Triangles = { { 0, 1, 2 } };
  // Where a body was flattened a corner has a second place, and two faces have no area.
  TriangleMesh twice = once;
  twice.Points.push_back(once.Points[0]);
  twice.Triangles = { { 0, 2, 1 }, { 3, 1, 2 }, { 1, 3, 0 }, { 2, 0, 3 } };
  for (const TriangleMesh& mesh : { once, twice })
  {
    const test::SkeletonResult expected = Skeletonize(test::ToPolyData(mesh));
    ASSERT_GE(expected.Skeleton.NumberOfNodes(), 1);
    for (const double unit : { 1e-30, 1e-11, 1e11, 1e30 })
    {
      SCOPED_TRACE(unit);
      const test::SkeletonResult result = Skeletonize(test::ToPolyData(test::Scaled(mesh, unit)));
      ASSERT_EQ(result.Skeleton.NumberOfNodes(), expected.Skeleton.NumberOfNodes());
      for (int n = 0; n < result.Skeleton.NumberOfNodes(); ++n)
      {
        const Eigen::Vector3d& position = expected.Skeleton.Graph[n].Position;
        EXPECT_LT((result.Skeleton.Graph[n].Position / unit - position).norm(), 1e-6);
        EXPECT_LT(position.norm(), 3.0);
      }
    }
  }
}

TEST(MSPSkeleton, SaysWhatIsWrong)
{
  vtkNew<vtkMSPSkeleton> filter;
  test::ErrorObserver errors(filter);

  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(errors.HasError("The mesh has no face")) << errors.Text();

  errors.Clear();
  const auto broken = test::WithMeasures(test::ToPolyData(test::MakeCylinder(1.0, 10.0, 12, 20)));
  broken->GetPointData()->GetArray(names::MSP)->SetTuple1(7, std::nan(""));
  filter->SetInputData(broken);
  filter->Update();
  EXPECT_TRUE(errors.HasError("\"MSP\" of the mesh is not finite at point 7")) << errors.Text();
}

TEST(MSPSkeleton, StopsWhenAsked)
{
  const test::Creature creature = test::MakeCreature(vtkCreatureSource::SNAKE);
  vtkNew<vtkMSPSkeleton> filter;
  filter->SetInputData(creature.Mesh);
  vtkNew<test::AbortObserver> abort;
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints(), 0);
}
}
