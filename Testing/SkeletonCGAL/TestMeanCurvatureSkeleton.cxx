// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "SkeletonResult.h"

#include <gtest/gtest.h>

#include <vtkMarrowMeanCurvatureSkeleton.h>
#include <vtkSegmentationTransfer.h>
#include <vtkSkeletonCorrespondence.h>

#include <cmath>
#include <memory>

namespace
{
using namespace marrow;

test::SkeletonResult Skeletonize(vtkPolyData* mesh)
{
  vtkNew<vtkMarrowMeanCurvatureSkeleton> filter;
  filter->SetInputData(mesh);
  return test::SkeletonResult(filter.Get());
}

TEST(MeanCurvatureSkeleton, CylinderGivesItsAxis)
{
  const double length = 12.0;
  test::ExpectCylinderAxis(
    Skeletonize(test::ToPolyData(test::MakeCylinder(1.0, length, 32, 80))), length, 0.8, 0.1);
}

TEST(MeanCurvatureSkeleton, TorusGivesOneClosedBranch)
{
  test::ExpectOneClosedBranch(
    Skeletonize(test::ToPolyData(test::MakeTorus(3.0, 1.0, 80, 30))), 3.0);
}

class Creatures : public testing::TestWithParam<std::pair<int, int>>
{
};

TEST_P(Creatures, LoopsAreTheGenusAndEveryVertexHasItsNode)
{
  const auto [shape, genus] = GetParam();
  const test::Creature creature = test::MakeCreature(shape);
  const test::SkeletonResult result = Skeletonize(creature.Mesh);
  EXPECT_EQ(result.Skeleton.NumberOfLoops(), genus);
  EXPECT_EQ(result.Skeleton.NumberOfComponents(), 1);

  for (const int node : result.NodeOfVertex)
  {
    EXPECT_GE(node, 0);
  }
  // The arrays of the nodes are those of φ.
  TriangleMesh mesh;
  ASSERT_EQ(ToTriangleMesh(result.Mesh, mesh), "");
  std::vector<double> agd;
  std::vector<int> count;
  vtkPointData* points = result.PolyData->GetPointData();
  ASSERT_TRUE(GetArray(result.Mesh->GetPointData(), names::AGD, mesh.NumberOfVertices(), agd));
  ASSERT_TRUE(GetArray(points, names::VertexCount, result.Skeleton.NumberOfNodes(), count));
  for (int n = 0; n < result.Skeleton.NumberOfNodes(); ++n)
  {
    const SkeletonNode& node = result.Skeleton.Graph[n];
    ASSERT_EQ(count[n], static_cast<int>(node.Vertices.size())) << "node " << n;
    if (count[n] == 0)
    {
      EXPECT_GT(node.Radius, 0.0) << "node " << n;
      continue;
    }
    double sum = 0.0;
    double distance = 0.0;
    for (const int v : node.Vertices)
    {
      sum += agd[v];
      distance += (mesh.Points[v] - node.Position).norm();
    }
    EXPECT_NEAR(node.AGD, sum / count[n], 1e-8) << "node " << n;
    EXPECT_NEAR(node.Radius, distance / count[n], 1e-8) << "node " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(MeanCurvatureSkeleton, Creatures,
  testing::Values(std::pair{ int(vtkCreatureSource::BIPED), 0 },
    std::pair{ int(vtkCreatureSource::OCTOPUS), 0 }, std::pair{ int(vtkCreatureSource::CHAIR), 3 },
    std::pair{ int(vtkCreatureSource::SNAKE), 0 }),
  [](const auto& instance) { return "Shape" + std::to_string(instance.param.first); });

TEST(MeanCurvatureSkeleton, TheSameInEveryRun)
{
  const test::Creature creature = test::MakeCreature(vtkCreatureSource::QUADRUPED);
  const test::SkeletonResult reference = Skeletonize(creature.Mesh);
  // Freed in disorder, so that the next run gets its memory in another order.
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 100000; ++i)
  {
    blocks.push_back(std::make_unique<char[]>(16 + 16 * (i * 7919 % 13)));
  }
  for (const int i : test::RandomOrder(static_cast<int>(blocks.size()), 3))
  {
    blocks[i].reset();
  }
  const test::SkeletonResult again = Skeletonize(creature.Mesh);
  EXPECT_EQ(again.NodeOfVertex, reference.NodeOfVertex);
  ASSERT_EQ(again.Skeleton.NumberOfNodes(), reference.Skeleton.NumberOfNodes());
  for (int n = 0; n < again.Skeleton.NumberOfNodes(); ++n)
  {
    ASSERT_EQ(again.Skeleton.Graph[n].Position, reference.Skeleton.Graph[n].Position);
  }
}

TEST(MeanCurvatureSkeleton, DoesNotDependOnTheUnit)
{
  const auto mesh = test::ToPolyData(test::MakeCylinder(1.0, 12.0, 24, 60));
  const test::SkeletonResult reference = Skeletonize(mesh);
  for (const double scale : { 1e-7, 3e6 })
  {
    const test::SkeletonResult scaled = Skeletonize(test::Transformed(
      mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return scale * p; }));
    EXPECT_EQ(scaled.Terminals, 2) << scale;
    EXPECT_EQ(scaled.Skeleton.NumberOfBranches(), 1) << scale;
    EXPECT_NEAR(scaled.Skeleton.TotalLength() / scale, reference.Skeleton.TotalLength(),
      0.02 * reference.Skeleton.TotalLength())
      << scale;
  }
}

TEST(MeanCurvatureSkeleton, ABallGivesAShortCurveOrSaysThatItGivesNone)
{
  vtkNew<vtkMarrowMeanCurvatureSkeleton> filter;
  test::ErrorObserver errors(filter);
  filter->SetInputData(test::ToPolyData(test::MakeSphere(1.0, 4)));
  filter->Update();
  marrow::Skeleton skeleton;
  if (errors.Errors.empty())
  {
    ASSERT_EQ(ToSkeleton(filter->GetOutput(0), skeleton), "");
    EXPECT_LT(skeleton.TotalLength(), 1.0);
  }
  else
  {
    EXPECT_TRUE(errors.HasError("None of the mesh's faces has an area")) << errors.Text();
  }
}

TEST(MeanCurvatureSkeleton, WeightsAreThoseOfTheFlow)
{
  const auto mesh = test::ToPolyData(test::MakeCylinder(1.0, 12.0, 24, 60));
  vtkNew<vtkMarrowMeanCurvatureSkeleton> filter;
  filter->SetInputData(mesh);
  filter->Update();
  const double byDefault = filter->GetOutput(0)->GetLength();
  filter->SetMediallyCenteredSpeedTradeoff(0.0);
  filter->Update();
  const double notCentered = filter->GetOutput(0)->GetLength();
  EXPECT_GT(std::abs(notCentered - byDefault), 0.02 * byDefault);
  filter->SetQualitySpeedTradeoff(1.0);
  filter->Update();
  EXPECT_NE(filter->GetOutput(0)->GetLength(), notCentered);
}

TEST(MeanCurvatureSkeleton, PointsWithoutTrianglesHaveNoNode)
{
  TriangleMesh cylinder = test::MakeCylinder(1.0, 10.0, 24, 40);
  cylinder.Points.insert(cylinder.Points.begin(), Eigen::Vector3d(0.0, 0.0, 0.5));
  for (auto& triangle : cylinder.Triangles)
  {
    triangle = { triangle[0] + 1, triangle[1] + 1, triangle[2] + 1 };
  }
  const test::SkeletonResult result = Skeletonize(test::ToPolyData(cylinder));
  EXPECT_EQ(result.NodeOfVertex[0], -1);
  // The numbers of the others are not shifted: φ lies around its node.
  for (int v = 1; v < cylinder.NumberOfVertices(); ++v)
  {
    const int node = result.NodeOfVertex[v];
    ASSERT_GE(node, 0);
    EXPECT_LT((cylinder.Points[v] - result.Skeleton.Graph[node].Position).norm(), 2.5);
  }
}

TEST(MeanCurvatureSkeleton, UsesTheMeasuresThatAreThereAndKeepsTheUsersArrays)
{
  const auto mesh = test::WithMeasures(test::MakeCreature(vtkCreatureSource::SNAKE).Mesh);
  mesh->GetPointData()->GetArray(names::AGD)->Fill(0.625);
  const test::SkeletonResult result = Skeletonize(mesh);
  test::ExpectAGD(result, 0.625);
  test::ExpectKept(mesh, result);
}

TEST(MeanCurvatureSkeleton, StandsForTheMSPSkeleton)
{
  test::CreatureOptions options;
  const test::Creature source = test::MakeCreature(vtkCreatureSource::QUADRUPED, options);
  options.Pose = 0.4;
  options.Seed = 2;
  const test::Creature target = test::MakeCreature(vtkCreatureSource::QUADRUPED, options);
  const test::SkeletonResult sourceResult = Skeletonize(source.Mesh);
  const test::SkeletonResult targetResult = Skeletonize(target.Mesh);

  vtkNew<vtkSkeletonCorrespondence> correspondence;
  test::ErrorObserver errors(correspondence);
  correspondence->SetInputData(0, sourceResult.PolyData);
  correspondence->SetInputData(1, targetResult.PolyData);
  correspondence->Update();
  EXPECT_TRUE(errors.Errors.empty()) << errors.Text();
  auto* matched = vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(0));
  std::vector<int> ids;
  ASSERT_TRUE(GetArray(
    matched->GetPointData(), names::CorrespondenceId, sourceResult.Skeleton.NumberOfNodes(), ids));
  int matchedTerminals = 0;
  for (int n = 0; n < sourceResult.Skeleton.NumberOfNodes(); ++n)
  {
    matchedTerminals += ids[n] >= 0 && sourceResult.Skeleton.TypeOf(n) == NodeType::Terminal;
  }
  EXPECT_GE(matchedTerminals, 4);

  vtkNew<vtkSegmentationTransfer> transfer;
  test::ErrorObserver transferErrors(transfer);
  transfer->SetInputData(0, sourceResult.Mesh);
  transfer->SetInputData(1, targetResult.Mesh);
  transfer->SetInputConnection(2, correspondence->GetOutputPort(0));
  transfer->SetInputConnection(3, correspondence->GetOutputPort(1));
  transfer->Update();
  EXPECT_TRUE(transferErrors.Errors.empty()) << transferErrors.Text();
  EXPECT_TRUE(transfer->GetOutput(0)->GetCellData()->GetArray(names::SegmentId));
}

TEST(MeanCurvatureSkeleton, SaysWhatIsWrong)
{
  vtkNew<vtkMarrowMeanCurvatureSkeleton> filter;
  test::ErrorObserver errors(filter);

  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(errors.HasError("The mesh has no face")) << errors.Text();

  // A tube that is open at one end: no small hole, and closing it would make another shape.
  errors.Clear();
  const TriangleMesh cylinder = test::MakeCylinder(1.0, 10.0, 12, 20);
  TriangleMesh open = cylinder;
  open.Triangles.erase(std::remove_if(open.Triangles.begin(), open.Triangles.end(),
                         [&](const auto& corners)
                         {
                           return std::all_of(corners.begin(), corners.end(),
                             [&](int corner) { return open.Points[corner].z() > 4.9; });
                         }),
    open.Triangles.end());
  filter->SetInputData(test::ToPolyData(open));
  filter->Update();
  EXPECT_TRUE(errors.HasError("12 border edges")) << errors.Text();
  EXPECT_TRUE(errors.HasError("close its holes first")) << errors.Text();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints(), 0);

  errors.Clear();
  const auto broken = test::WithMeasures(test::ToPolyData(cylinder));
  broken->GetPointData()->GetArray(names::MSP)->SetTuple1(7, std::nan(""));
  filter->SetInputData(broken);
  filter->Update();
  EXPECT_TRUE(errors.HasError("\"MSP\" of the mesh is not finite at point 7")) << errors.Text();

  // Every point in one place.
  errors.Clear();
  TriangleMesh flat = cylinder;
  for (auto& point : flat.Points)
  {
    point = Eigen::Vector3d(1.0, 2.0, 3.0);
  }
  filter->SetInputData(test::ToPolyData(flat));
  filter->Update();
  EXPECT_TRUE(errors.HasError("None of the mesh's faces has an area")) << errors.Text();
}

TEST(MeanCurvatureSkeleton, StopsWhenAsked)
{
  const test::Creature creature = test::MakeCreature(vtkCreatureSource::SNAKE);
  // Measures are there, so that it is the contraction that is stopped.
  vtkNew<vtkMarrowMeanCurvatureSkeleton> filter;
  test::ErrorObserver errors(filter);
  filter->SetInputData(test::WithMeasures(creature.Mesh));
  vtkNew<test::AbortObserver> abort;
  abort->After = 0.2;
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_TRUE(errors.Errors.empty()) << errors.Text();
}
}
