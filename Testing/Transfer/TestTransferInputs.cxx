// SPDX-License-Identifier: BSD-3-Clause
// What vtkSegmentationTransfer accepts, and what it says about the rest.
#include "ErrorObserver.h"
#include "TransferTestData.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

using namespace marrow;
using namespace marrow::test;

TEST(TransferInputs, OtherArrayOfSegments)
{
  auto renamed = Data::New();
  renamed->ShallowCopy(Source().Mesh);
  std::vector<int> labels = LabelsOf(renamed);
  for (int& label : labels)
  {
    label = 100 - 50 * label;
  }
  renamed->GetCellData()->RemoveArray(names::SegmentId);
  SetIntArray(renamed->GetCellData(), "Parts", labels);
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, { renamed, Source().Skeleton }, Source());
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasError("no cell array \"SegmentId\"")) << errors.Text();
  EXPECT_TRUE(errors.HasError("it has \"Parts\"")) << errors.Text();

  errors.Clear();
  transfer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Parts");
  transfer->Update();
  EXPECT_TRUE(errors.Text().empty()) << errors.Text();
  EXPECT_GE(Accuracy(Output(transfer), labels), 0.97);
}

TEST(TransferInputs, VertexCellsOfSkeletonsAreNoBranches)
{
  const Prepared& target = Quadruped(2, 0.4, 0.2, 6000);
  const auto withVertexCells = [](const Prepared& prepared) -> Prepared
  {
    // vtkCleanPolyData makes such cells of lines that collapse.
    auto skeleton = Data::New();
    skeleton->ShallowCopy(prepared.Skeleton);
    skeleton->GetCellData()->Initialize();
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType node = 0; node < 3; ++node)
    {
      vertices->InsertNextCell(1, &node);
    }
    skeleton->SetVerts(vertices);
    return { prepared.Mesh, skeleton };
  };
  vtkNew<vtkSegmentationTransfer> plain;
  Connect(plain, Source(), target);
  plain->Update();
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, withVertexCells(Source()), withVertexCells(target));
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.Text().empty()) << errors.Text();
  EXPECT_EQ(LabelsOf(Output(plain)), LabelsOf(Output(transfer)));
}

TEST(TransferInputs, ErrorsNameSideAndRemedy)
{
  const auto expectError = [](vtkSegmentationTransfer* transfer, const std::string& part)
  {
    ErrorObserver errors(transfer);
    transfer->Update();
    EXPECT_TRUE(errors.HasError(part)) << errors.Text();
  };
  const Prepared& good = Source();
  {
    auto labelled = Data::New();
    labelled->ShallowCopy(good.Mesh);
    SetIntArray(labelled->GetCellData(), names::SegmentId, std::vector<int>(5, 1));
    vtkNew<vtkSegmentationTransfer> transfer;
    Connect(transfer, { labelled, good.Skeleton }, good);
    expectError(transfer, "has 5 tuples of 1 components");
  }
  {
    auto labelled = Data::New();
    labelled->ShallowCopy(good.Mesh);
    SetArray(labelled->GetCellData(), names::SegmentId,
      std::vector<double>(labelled->GetNumberOfCells(), 0.5));
    vtkNew<vtkSegmentationTransfer> transfer;
    Connect(transfer, { labelled, good.Skeleton }, good);
    expectError(transfer, "is no integer at cell 0");
  }
  {
    vtkNew<vtkSegmentationTransfer> transfer;
    vtkNew<vtkPolyData> empty;
    Connect(transfer, good, { empty.Get(), nullptr });
    expectError(transfer, "Target: The mesh has no face");
  }
  {
    auto bare = Data::New();
    bare->ShallowCopy(good.Mesh);
    bare->GetPointData()->RemoveArray(names::SkeletonNodeId);
    vtkNew<vtkSegmentationTransfer> transfer;
    Connect(transfer, good, { bare, good.Skeleton });
    expectError(transfer, "Target: a skeleton is connected, but the mesh has no point array");
  }
  {
    vtkNew<vtkSegmentationTransfer> transfer;
    CreatureOptions options;
    options.Faces = 2500;
    const Prepared capsule = Prepare(MakeCreature(vtkCreatureSource::CAPSULE, options).Mesh);
    Connect(transfer, good, { good.Mesh, capsule.Skeleton });
    expectError(transfer, "Target: the skeleton does not belong to the mesh");
  }
}

namespace
{
/// Transfers and checks that every cell has a label of the source.
void ExpectValid(vtkPolyData* source, vtkPolyData* target)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source);
  transfer->SetInputData(1, target);
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.Errors.empty()) << errors.Text();
  const std::vector<int> sourceLabels = LabelsOf(source);
  const std::set<int> known(sourceLabels.begin(), sourceLabels.end());
  const std::vector<int> labels = LabelsOf(Output(transfer));
  ASSERT_EQ(static_cast<vtkIdType>(labels.size()), target->GetNumberOfCells());
  for (int label : labels)
  {
    EXPECT_TRUE(known.count(label));
  }
}

Data SmallCreature(int shape, int seed)
{
  CreatureOptions options;
  options.Faces = 2500;
  options.Seed = seed;
  options.Pose = 0.3;
  return MakeCreature(shape, options).Mesh;
}
}

TEST(TransferInputs, OpenMeshes)
{
  const Data whole = SmallCreature(vtkCreatureSource::QUADRUPED, 1);
  // The tips of the feet are cut off.
  double bounds[6];
  whole->GetBounds(bounds);
  const double floor = bounds[2] + 0.15 * (bounds[3] - bounds[2]);
  const Data open =
    Subset(whole, [&](const TriangleMesh& mesh, int t) { return mesh.Centroid(t).y() > floor; });
  ASSERT_LT(open->GetNumberOfCells(), whole->GetNumberOfCells());
  ExpectValid(whole, open);
  ExpectValid(open, whole);
}

TEST(TransferInputs, SeveralComponentsAndLoops)
{
  const Data creature = SmallCreature(vtkCreatureSource::QUADRUPED, 1);
  // Head and tail on their own, without the neck between.
  const std::vector<int> labels = LabelsOf(creature);
  const Data parts = Subset(creature, [&](const TriangleMesh&, int t) { return labels[t] != 1; });
  ExpectValid(creature, parts);
  ExpectValid(parts, creature);
  ExpectValid(
    SmallCreature(vtkCreatureSource::CHAIR, 1), SmallCreature(vtkCreatureSource::CHAIR, 2));
  ExpectValid(SmallCreature(vtkCreatureSource::TORUS, 1), creature);
  ExpectValid(creature, SmallCreature(vtkCreatureSource::SNAKE, 1));
}

TEST(TransferInputs, TinyMeshesAndOneSegment)
{
  TriangleMesh tetrahedron;
  tetrahedron.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  tetrahedron.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  const Data tiny = ToPolyData(tetrahedron);
  SetIntArray(tiny->GetCellData(), names::SegmentId, { 4, 4, 4, 9 });
  const Data snake = SmallCreature(vtkCreatureSource::SNAKE, 1);
  ExpectValid(tiny, tiny);
  ExpectValid(tiny, snake);
  ExpectValid(snake, tiny);
  SetIntArray(
    snake->GetCellData(), names::SegmentId, std::vector<int>(snake->GetNumberOfCells(), -3));
  ExpectValid(snake, SmallCreature(vtkCreatureSource::SNAKE, 2));
}

TEST(TransferInputs, WhatIsKnownOfAMeshIsForgottenWithIt)
{
  const Data source = SmallCreature(vtkCreatureSource::QUADRUPED, 1);
  const Data target = SmallCreature(vtkCreatureSource::QUADRUPED, 2);
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source);
  transfer->SetInputData(1, target);
  transfer->Update();
  const std::vector<int> before = LabelsOf(Output(transfer));

  // The same object with another surface.
  const Data other = SmallCreature(vtkCreatureSource::QUADRUPED, 3);
  target->ShallowCopy(other);
  target->Modified();
  transfer->Update();
  vtkNew<vtkSegmentationTransfer> fresh;
  fresh->SetInputData(0, source);
  fresh->SetInputData(1, other);
  fresh->Update();
  EXPECT_NE(LabelsOf(Output(transfer)), before);
  EXPECT_EQ(LabelsOf(Output(transfer)), LabelsOf(Output(fresh)));

  // Other segments of the same source.
  std::vector<int> segments = LabelsOf(source);
  std::transform(segments.begin(), segments.end(), segments.begin(), [](int s) { return s + 10; });
  SetIntArray(source->GetCellData(), names::SegmentId, segments);
  source->Modified();
  transfer->Update();
  std::vector<int> expected = LabelsOf(Output(fresh));
  std::transform(expected.begin(), expected.end(), expected.begin(), [](int s) { return s + 10; });
  EXPECT_EQ(LabelsOf(Output(transfer)), expected);
}

TEST(TransferInputs, SkeletonsAreTakenAwayAgain)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  vtkNew<vtkPolyData> skeleton;
  transfer->SetInputData(2, skeleton);
  transfer->SetInputData(3, skeleton);
  transfer->RemoveSourceSkeleton();
  EXPECT_EQ(transfer->GetNumberOfInputConnections(2), 0);
  EXPECT_EQ(transfer->GetNumberOfInputConnections(3), 1);
  transfer->RemoveTargetSkeleton();
  EXPECT_EQ(transfer->GetNumberOfInputConnections(3), 0);
}

TEST(TransferInputs, NoiseIsNoSegmentation)
{
  const Data snake = SmallCreature(vtkCreatureSource::SNAKE, 1);
  std::vector<int> labels(snake->GetNumberOfCells());
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    labels[t] = static_cast<int>(t);
  }
  SetIntArray(snake->GetCellData(), names::SegmentId, labels);
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, snake);
  transfer->SetInputData(1, snake);
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasError("connected pieces, more than 500")) << errors.Text();
}
