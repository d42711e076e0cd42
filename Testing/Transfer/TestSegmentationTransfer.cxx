// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayNames.h"
#include "ErrorObserver.h"
#include "MeshBridge.h"
#include "SegmentLoops.h"
#include "TestMeshes.h"
#include "vtkSegmentationTransfer.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMSPSkeleton.h>
#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <map>
#include <set>

using namespace marrow;
using namespace marrow::test;

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

Data Output(vtkAlgorithm* filter, int port = 0)
{
  auto copy = Data::New();
  copy->ShallowCopy(filter->GetOutputDataObject(port));
  return copy;
}

/// A creature with the arrays of vtkMSPSkeleton and its skeleton.
struct Prepared
{
  Data Mesh;
  Data Skeleton;
};

Prepared Prepare(vtkPolyData* mesh)
{
  vtkNew<vtkMSPSkeleton> skeleton;
  skeleton->SetInputData(mesh);
  skeleton->Update();
  return { Output(skeleton, 1), Output(skeleton, 0) };
}

const Prepared& Quadruped(int seed, double pose, double proportion, int faces)
{
  static std::map<std::tuple<int, double, double, int>, Prepared> cache;
  auto& entry = cache[{ seed, pose, proportion, faces }];
  if (!entry.Mesh)
  {
    CreatureOptions options;
    options.Seed = seed;
    options.Pose = pose;
    options.Proportion = proportion;
    options.Faces = faces;
    entry = Prepare(MakeCreature(vtkCreatureSource::QUADRUPED, options).Mesh);
  }
  return entry;
}

const Prepared& Source()
{
  return Quadruped(1, 0.0, 0.0, 6000);
}

void Connect(vtkSegmentationTransfer* transfer, const Prepared& source, const Prepared& target)
{
  transfer->SetInputData(0, source.Mesh);
  transfer->SetInputData(1, target.Mesh);
  transfer->SetInputData(2, source.Skeleton);
  transfer->SetInputData(3, target.Skeleton);
}

std::vector<int> LabelsOf(vtkPolyData* mesh)
{
  std::vector<int> labels;
  GetArray(
    mesh->GetCellData(), names::SegmentId, static_cast<int>(mesh->GetNumberOfCells()), labels);
  return labels;
}

double Accuracy(vtkPolyData* result, const std::vector<int>& truth)
{
  TriangleMesh mesh;
  ToTriangleMesh(result, mesh);
  const std::vector<int> labels = LabelsOf(result);
  double right = 0.0;
  double total = 0.0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const double area = mesh.Area(t);
    right += labels.at(t) == truth[t] ? area : 0.0;
    total += area;
  }
  return right / total;
}

double TransferAccuracy(const Prepared& source, const Prepared& target)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, source, target);
  transfer->Update();
  return Accuracy(Output(transfer), LabelsOf(target.Mesh));
}
}

TEST(SegmentationTransfer, ToItselfChangesNothing)
{
  EXPECT_GE(TransferAccuracy(Source(), Source()), 0.99);
}

TEST(SegmentationTransfer, QuadrupedsOfOtherPoseProportionAndResolution)
{
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(2, 0.5, 0.5, 6000)), 0.95);
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(5, 1.0, 0.3, 4000)), 0.95);
  EXPECT_GE(TransferAccuracy(Source(), Quadruped(6, 0.3, 1.0, 10000)), 0.95);
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
  EXPECT_LE(output->GetCellData()->GetArray(names::SegmentConfidence)->GetRange()[1], 0.1);
}

TEST(SegmentationTransfer, BranchWithoutPartnerIsReported)
{
  // The source's tail has no partner: its segment (7) joins the torso.
  Prepared source{ Source().Mesh, Data::New() };
  source.Skeleton->DeepCopy(Source().Skeleton);
  Prepared target{ Source().Mesh, Data::New() };
  std::vector<int> nodeOfVertex;
  GetArray(source.Mesh->GetPointData(), names::SkeletonNodeId,
    static_cast<int>(source.Mesh->GetNumberOfPoints()), nodeOfVertex);
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
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasWarning("missing altogether: 7")) << errors.Text();
  std::vector<int> expected = labels;
  std::replace(expected.begin(), expected.end(), 7, 0);
  EXPECT_GT(Accuracy(Output(transfer), expected), 0.97);
}

TEST(SegmentationTransfer, OtherArrayOfSegments)
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
  EXPECT_GE(Accuracy(Output(transfer), labels), 0.99);
}

TEST(SegmentationTransfer, ErrorsNameSideAndRemedy)
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
    expectError(transfer, "Target: The mesh is empty");
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
/// Only the triangles for which `keep` holds.
Data Subset(vtkPolyData* input, const std::function<bool(const TriangleMesh&, int)>& keep)
{
  TriangleMesh mesh;
  ToTriangleMesh(input, mesh);
  const std::vector<int> labels = LabelsOf(input);
  TriangleMesh part;
  std::vector<int> partLabels;
  std::map<int, int> newVertex;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (!keep(mesh, t))
    {
      continue;
    }
    std::array<int, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      const int v = mesh.Triangles[t][k];
      const auto [entry, isNew] = newVertex.insert({ v, static_cast<int>(part.Points.size()) });
      if (isNew)
      {
        part.Points.push_back(mesh.Points[v]);
      }
      corners[k] = entry->second;
    }
    part.Triangles.push_back(corners);
    partLabels.push_back(labels[t]);
  }
  Data result = ToPolyData(part);
  SetIntArray(result->GetCellData(), names::SegmentId, partLabels);
  return result;
}

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

TEST(SegmentationTransfer, OpenMeshes)
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

TEST(SegmentationTransfer, SeveralComponentsAndLoops)
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

TEST(SegmentationTransfer, TinyMeshesAndOneSegment)
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

TEST(SegmentationTransfer, NoiseIsNoSegmentation)
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
