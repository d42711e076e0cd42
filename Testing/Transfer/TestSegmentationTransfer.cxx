// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "SegmentLoops.h"
#include "TransferTestData.h"

#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace marrow;
using namespace marrow::test;

TEST(SegmentationTransfer, ToItselfMovesBoundariesByAFaceAtMost)
{
  // The cut shortens boundaries and draws them to where the source's other boundaries run, within
  // what the map leaves open.
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, Source(), Source());
  transfer->Update();
  const std::vector<int> truth = LabelsOf(Source().Mesh);
  const std::vector<int> labels = LabelsOf(Output(transfer));
  EXPECT_GE(Accuracy(Output(transfer), truth), 0.97);
  TriangleMesh mesh;
  ToTriangleMesh(Source().Mesh, mesh);
  const auto labelsAround = [&](int triangle)
  {
    std::set<int> around;
    for (const int corner : mesh.Triangles[triangle])
    {
      mesh.ForEachNeighbor(corner,
        [&](int v) {
          mesh.ForEachOutgoing(
            v, [&](int h) { around.insert(truth[TriangleMesh::TriangleOf(h)]); });
        });
    }
    return around;
  };
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_TRUE(labelsAround(t).count(labels[t]) > 0) << "face " << t;
  }
}

TEST(SegmentationTransfer, QuadrupedsOfOtherPoseProportionAndResolution)
{
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(2, 0.5, 0.5, 6000)), 0.95);
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(5, 1.0, 0.3, 4000)), 0.95);
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(6, 0.3, 1.0, 10000)), 0.95);
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(9, 0.8, 0.4, 15000)), 0.95);
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(10, 0.4, 0.8, 7000)), 0.95);
  // Where both are at their utmost the ring at the neck sits too far out.
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(7, 1.0, 1.0, 10000)), 0.90);
}

TEST(SegmentationTransfer, ResultIsAValidLabelling)
{
  const Prepared& target = Quadruped(2, 0.5, 0.5, 6000);
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, Source(), target);
  transfer->Update();
  const Data output = Output(transfer);

  // The mesh and its arrays are the input's.
  EXPECT_EQ(output->GetPoints(), target.Mesh->GetPoints());
  EXPECT_EQ(output->GetPolys(), target.Mesh->GetPolys());
  EXPECT_TRUE(output->GetPointData()->HasArray(names::SkeletonNodeId));
  EXPECT_TRUE(vtkIntArray::SafeDownCast(output->GetCellData()->GetArray(names::SegmentId)));

  const std::vector<int> labels = LabelsOf(output);
  ASSERT_EQ(static_cast<vtkIdType>(labels.size()), output->GetNumberOfCells());
  const std::vector<int> sourceLabels = LabelsOf(Source().Mesh);
  const std::set<int> known(sourceLabels.begin(), sourceLabels.end());
  EXPECT_EQ(std::set<int>(labels.begin(), labels.end()), known);
  // Every segment of a creature is one piece.
  TriangleMesh mesh;
  ToTriangleMesh(output, mesh);
  EXPECT_EQ(FindPieces(mesh, labels).NumberOfPieces(), static_cast<int>(known.size()));

  auto* confidence =
    vtkDoubleArray::SafeDownCast(output->GetCellData()->GetArray(names::SegmentConfidence));
  ASSERT_TRUE(confidence);
  ASSERT_EQ(confidence->GetNumberOfTuples(), output->GetNumberOfCells());
  EXPECT_GE(confidence->GetRange()[0], 0.0);
  EXPECT_LE(confidence->GetRange()[1], 1.0);
  EXPECT_GT(confidence->GetRange()[1], confidence->GetRange()[0]);
}

TEST(SegmentationTransfer, BoundariesCorrespond)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, Source(), Quadruped(2, 0.5, 0.5, 6000));
  transfer->Update();
  const Data source = Output(transfer, 1);
  const Data target = Output(transfer, 2);
  // Head, neck, four legs and tail: seven boundaries.
  EXPECT_EQ(source->GetNumberOfCells(), 7);
  EXPECT_EQ(target->GetNumberOfCells(), 7);
  const auto value = [](vtkPolyData* data, const char* name, vtkIdType cell)
  { return data->GetCellData()->GetArray(name)->GetTuple1(cell); };
  std::map<double, vtkIdType> sourceCell;
  for (vtkIdType c = 0; c < source->GetNumberOfCells(); ++c)
  {
    EXPECT_TRUE(sourceCell.insert({ value(source, names::BoundaryId, c), c }).second);
  }
  for (vtkIdType c = 0; c < target->GetNumberOfCells(); ++c)
  {
    const auto partner = sourceCell.find(value(target, names::BoundaryId, c));
    ASSERT_NE(partner, sourceCell.end());
    for (const char* name : { "FirstSegmentId", "SecondSegmentId" })
    {
      EXPECT_EQ(value(target, name, c), value(source, name, partner->second));
    }
    vtkNew<vtkIdList> targetLine;
    vtkNew<vtkIdList> sourceLine;
    target->GetCellPoints(c, targetLine);
    source->GetCellPoints(partner->second, sourceLine);
    EXPECT_EQ(targetLine->GetNumberOfIds(), sourceLine->GetNumberOfIds());
    EXPECT_EQ(targetLine->GetId(0), targetLine->GetId(targetLine->GetNumberOfIds() - 1));
  }
}

TEST(SegmentationTransfer, IndependentOfOrderPlaceAndUnit)
{
  const Prepared& target = Quadruped(5, 1.0, 0.3, 4000);
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, Source(), target);
  transfer->Update();
  const std::vector<int> reference = LabelsOf(Output(transfer));

  const PermutedPolyData permuted = Permuted(target.Mesh, 7);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto move = [&](vtkPolyData* data)
  {
    vtkNew<vtkPoints> moved;
    moved->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      const Eigen::Vector3d p =
        250.0 * rotation * Eigen::Vector3d(data->GetPoint(i)) + Eigen::Vector3d(10.0, -20.0, 5.0);
      moved->InsertNextPoint(p.data());
    }
    data->SetPoints(moved);
  };
  // The skeleton is computed anew on the moved mesh, so that all of its measures fit.
  auto bare = Data::New();
  bare->SetPoints(permuted.Mesh->GetPoints());
  bare->SetPolys(permuted.Mesh->GetPolys());
  move(bare);
  vtkNew<vtkSegmentationTransfer> other;
  Connect(other, Source(), Prepare(bare));
  other->Update();
  const std::vector<int> labels = LabelsOf(Output(other));
  ASSERT_EQ(labels.size(), reference.size());
  std::size_t same = 0;
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    same += labels[t] == reference[permuted.OldCell[t]] ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(same) / labels.size(), 0.97);
}

TEST(SegmentationTransfer, SameBitsOnAnyNumberOfThreads)
{
  std::vector<int> labels[2];
  std::vector<double> confidence[2];
  for (int run = 0; run < 2; ++run)
  {
    vtkSMPTools::Initialize(run == 0 ? 4 : 1);
    vtkNew<vtkSegmentationTransfer> transfer;
    Connect(transfer, Source(), Quadruped(5, 1.0, 0.3, 4000));
    transfer->Update();
    const Data output = Output(transfer);
    labels[run] = LabelsOf(output);
    GetArray(output->GetCellData(), names::SegmentConfidence,
      static_cast<int>(output->GetNumberOfCells()), confidence[run]);
  }
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(labels[0], labels[1]);
  EXPECT_EQ(confidence[0], confidence[1]);
}

TEST(SegmentationTransfer, TwoMeshesAreEnough)
{
  CreatureOptions options;
  options.Faces = 3000;
  const Data source = MakeCreature(vtkCreatureSource::QUADRUPED, options).Mesh;
  options.Seed = 2;
  options.Pose = 0.4;
  const Data target = MakeCreature(vtkCreatureSource::QUADRUPED, options).Mesh;
  const std::vector<int> truth = LabelsOf(target);
  target->GetCellData()->RemoveArray(names::SegmentId);
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source);
  transfer->SetInputData(1, target);
  transfer->Update();
  EXPECT_GT(Accuracy(Output(transfer), truth), 0.9);
  // The inputs are as they were.
  EXPECT_FALSE(target->GetCellData()->HasArray(names::SegmentId));
  EXPECT_FALSE(target->GetPointData()->HasArray(names::MSP));
}

TEST(SegmentationTransfer, NothingMatchedAlignsAsWholeAndSaysSo)
{
  const auto unmatched = [](const Prepared& prepared)
  {
    Prepared result{ prepared.Mesh, Data::New() };
    result.Skeleton->DeepCopy(prepared.Skeleton);
    SetIdArray(result.Skeleton->GetPointData(), names::CorrespondenceId,
      std::vector<int>(result.Skeleton->GetNumberOfPoints(), -1));
    SetIdArray(result.Skeleton->GetCellData(), names::BranchCorrespondenceId,
      std::vector<int>(result.Skeleton->GetNumberOfCells(), -1));
    return result;
  };
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, unmatched(Source()), unmatched(Source()));
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasWarning("aligned as wholes")) << errors.Text();
  const Data output = Output(transfer);
  EXPECT_GT(Accuracy(output, LabelsOf(Source().Mesh)), 0.95);
  EXPECT_EQ(output->GetFieldData()->GetArray(names::MatchingCost)->GetTuple1(0), 1.0);
  // The surfaces agree all the same, and that is what the confidence goes by.
  EXPECT_GT(output->GetFieldData()->GetArray(names::MatchingConfidence)->GetTuple1(0), 0.9);
}

TEST(SegmentationTransfer, APartThatTheTargetHasNotGotIsReported)
{
  // The target's tail is cut off.
  const Data whole = Source().Mesh;
  const std::vector<int> labels = LabelsOf(whole);
  const Data target = Subset(whole, [&](const TriangleMesh&, int t) { return labels[t] != 7; });
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, whole);
  transfer->SetInputData(1, target);
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasWarning("missing altogether: 7")) << errors.Text();
  EXPECT_GT(Accuracy(Output(transfer), LabelsOf(target)), 0.95);
}

TEST(SegmentationTransfer, APartMatchedOnNeitherSideIsFoundWhereItLies)
{
  Prepared source{ Source().Mesh, Data::New() };
  source.Skeleton->DeepCopy(Source().Skeleton);
  Prepared target{ Source().Mesh, Data::New() };
  std::vector<int> nodeOfVertex;
  GetArray(source.Mesh->GetPointData(), names::SkeletonNodeId,
    static_cast<int>(source.Mesh->GetNumberOfPoints()), nodeOfVertex);
  // Both tails are without a partner.
  std::vector<int> tail(source.Skeleton->GetNumberOfPoints(), 0);
  const std::vector<int> labels = LabelsOf(source.Mesh);
  TriangleMesh mesh;
  ToTriangleMesh(source.Mesh, mesh);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    for (int corner : mesh.Triangles[t])
    {
      tail[nodeOfVertex[corner]] += labels[t] == 7 ? 1 : -1;
    }
  }
  std::vector<int> branches;
  std::vector<int> nodes(source.Skeleton->GetNumberOfPoints(), -1);
  int unmatched = 0;
  for (vtkIdType c = 0; c < source.Skeleton->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> line;
    source.Skeleton->GetCellPoints(c, line);
    int inTail = 0;
    for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
    {
      inTail += tail[line->GetId(i)] > 0 ? 1 : 0;
    }
    const bool isTail = 2 * inTail > line->GetNumberOfIds();
    unmatched += isTail ? 1 : 0;
    branches.push_back(isTail ? -1 : static_cast<int>(c));
    for (vtkIdType end : { vtkIdType(0), line->GetNumberOfIds() - 1 })
    {
      nodes[line->GetId(end)] =
        isTail ? nodes[line->GetId(end)] : static_cast<int>(line->GetId(end));
    }
  }
  ASSERT_EQ(unmatched, 1);
  SetIdArray(source.Skeleton->GetPointData(), names::CorrespondenceId, nodes);
  SetIdArray(source.Skeleton->GetCellData(), names::BranchCorrespondenceId, branches);
  target.Skeleton->DeepCopy(source.Skeleton);
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, source, target);
  transfer->Update();
  EXPECT_GT(Accuracy(Output(transfer), labels), 0.97);
}
