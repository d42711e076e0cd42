// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "TestMeshes.h"
#include "vtkCollectionTransfer.h"
#include "vtkSegmentationTransfer.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

using namespace marrow;
using namespace marrow::test;

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

std::vector<double> ConfidenceOf(vtkPolyData* mesh)
{
  std::vector<double> confidence;
  GetArray(mesh->GetCellData(), names::SegmentConfidence,
    static_cast<int>(mesh->GetNumberOfCells()), confidence);
  return confidence;
}

double Accuracy(vtkPolyData* result, vtkPolyData* truth)
{
  TriangleMesh mesh;
  ToTriangleMesh(result, mesh);
  const std::vector<int> labels = LabelsOf(result);
  const std::vector<int> right = LabelsOf(truth);
  double same = 0.0;
  double total = 0.0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    total += mesh.Area(t);
    same += labels.at(t) == right[t] ? mesh.Area(t) : 0.0;
  }
  return same / total;
}

Mesh Unlabelled(vtkPolyData* mesh)
{
  auto copy = Mesh::New();
  copy->SetPoints(mesh->GetPoints());
  copy->SetPolys(mesh->GetPolys());
  return copy;
}

/// Bipeds of different poses and proportions, labelled.
const std::vector<Mesh>& Bipeds()
{
  static std::vector<Mesh> meshes;
  for (int seed = 1; meshes.size() < 5; ++seed)
  {
    CreatureOptions options;
    options.Seed = seed;
    options.Pose = 0.6;
    options.Proportion = 0.6;
    meshes.push_back(MakeCreature(vtkCreatureSource::BIPED, options).Mesh);
  }
  return meshes;
}

vtkSmartPointer<vtkMultiBlockDataSet> Blocks(
  const std::vector<vtkSmartPointer<vtkDataObject>>& leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const auto index = static_cast<unsigned int>(i);
    blocks->SetBlock(index, leaves[i]);
    blocks->GetMetaData(index)->Set(
      vtkCompositeDataSet::NAME(), ("mesh " + std::to_string(i)).c_str());
  }
  return blocks;
}

/// The bipeds, the first of them labelled, in the order given.
vtkSmartPointer<vtkMultiBlockDataSet> Collection(const std::vector<int>& order)
{
  std::vector<vtkSmartPointer<vtkDataObject>> leaves;
  for (const int i : order)
  {
    leaves.emplace_back(i == 0 ? Bipeds()[0] : Unlabelled(Bipeds()[i]));
  }
  return Blocks(leaves);
}

Mesh Block(vtkCollectionTransfer* filter, unsigned int index)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return vtkPolyData::SafeDownCast(blocks->GetBlock(index));
}

vtkTable* Table(vtkCollectionTransfer* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
}
}

TEST(CollectionTransfer, OneLabelledMeshLabelsTheOthers)
{
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(Collection({ 0, 1, 2, 3, 4 }));
  ErrorObserver errors(collection);
  collection->Update();
  EXPECT_TRUE(errors.Text().empty()) << errors.Text();
  EXPECT_EQ(LabelsOf(Block(collection, 0)), LabelsOf(Bipeds()[0]));
  for (const double confidence : ConfidenceOf(Block(collection, 0)))
  {
    EXPECT_EQ(confidence, 1.0);
  }
  for (unsigned int i = 1; i < 5; ++i)
  {
    const Mesh labelled = Block(collection, i);
    EXPECT_GE(Accuracy(labelled, Bipeds()[i]), 0.94) << i;
    EXPECT_EQ(labelled->GetPoints(), Bipeds()[i]->GetPoints());
    const std::vector<double> confidence = ConfidenceOf(labelled);
    ASSERT_EQ(static_cast<vtkIdType>(confidence.size()), labelled->GetNumberOfCells());
    EXPECT_GE(*std::min_element(confidence.begin(), confidence.end()), 0.0);
    EXPECT_LE(*std::max_element(confidence.begin(), confidence.end()), 1.0);
    EXPECT_STREQ(labelled->GetCellData()->GetScalars()->GetName(), names::SegmentId);
  }
  vtkTable* table = Table(collection);
  ASSERT_EQ(table->GetNumberOfRows(), 5);
  EXPECT_EQ(table->GetValueByName(0, "IsSource").ToInt(), 1);
  EXPECT_EQ(table->GetValueByName(3, "IsSource").ToInt(), 0);
  EXPECT_EQ(table->GetValueByName(3, "Block").ToString(), "mesh 3");
  EXPECT_EQ(table->GetValueByName(3, "Source").ToString(), "mesh 0");
  EXPECT_GT(table->GetValueByName(3, "Confidence").ToDouble(), 0.7);
  EXPECT_GT(table->GetValueByName(3, "Against").ToDouble(), 0.0);
}

TEST(CollectionTransfer, RejectedAnswersAreGivenOutOnDemand)
{
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(Collection({ 0, 1, 2 }));
  collection->Update();
  const std::vector<int> taken = LabelsOf(Block(collection, 1));
  EXPECT_FALSE(Block(collection, 1)->GetCellData()->HasArray(names::RejectedSegmentId));
  collection->SetNumberOfRejectedAnswers(2);
  collection->Update();
  const Mesh target = Block(collection, 1);
  EXPECT_EQ(LabelsOf(target), taken);
  EXPECT_FALSE(Block(collection, 0)->GetCellData()->HasArray(names::RejectedSegmentId));
  // A biped is as well seen from behind: left for right, arms or legs or both.
  vtkDataArray* rejected = target->GetCellData()->GetArray(names::RejectedSegmentId);
  ASSERT_TRUE(rejected);
  ASSERT_EQ(rejected->GetNumberOfComponents(), 2);
  ASSERT_EQ(rejected->GetNumberOfTuples(), target->GetNumberOfCells());
  vtkDataArray* against = target->GetFieldData()->GetArray(names::RejectedAgainst);
  vtkDataArray* difference = target->GetFieldData()->GetArray(names::RejectedDifference);
  ASSERT_TRUE(against && difference);
  TriangleMesh mesh;
  ToTriangleMesh(target, mesh);
  const auto shareOf = [&](const std::function<bool(int)>& isCounted)
  {
    double sum = 0.0;
    double total = 0.0;
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      total += mesh.Area(t);
      sum += isCounted(t) ? mesh.Area(t) : 0.0;
    }
    return sum / total;
  };
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_GT(against->GetTuple1(i), 0.0);
    EXPECT_GE(difference->GetTuple1(i), 0.05);
    // As coarse as they are, the figure tells what is seen.
    EXPECT_NEAR(shareOf([&](int t) { return rejected->GetComponent(t, i) != taken[t]; }),
      difference->GetTuple1(i), 0.03);
  }
  EXPECT_LE(against->GetTuple1(0) + difference->GetTuple1(0),
    against->GetTuple1(1) + difference->GetTuple1(1));
  EXPECT_GE(
    shareOf([&](int t) { return rejected->GetComponent(t, 0) != rejected->GetComponent(t, 1); }),
    0.03);
}

TEST(CollectionTransfer, OneTargetGetsWhatTheTransferGives)
{
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(Collection({ 0, 1 }));
  collection->Update();
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, Bipeds()[0]);
  transfer->SetInputData(1, Unlabelled(Bipeds()[1]));
  transfer->Update();
  EXPECT_GE(Accuracy(Block(collection, 1), Bipeds()[1]),
    Accuracy(vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(0)), Bipeds()[1]) - 0.005);
}

TEST(CollectionTransfer, NeitherOrderNorThreadsDecide)
{
  const std::vector<int> order{ 3, 1, 0, 2 };
  vtkNew<vtkCollectionTransfer> one;
  one->SetInputDataObject(Collection({ 0, 1, 2, 3 }));
  vtkNew<vtkCollectionTransfer> other;
  other->SetInputDataObject(Collection(order));
  vtkSMPTools::Initialize(1);
  one->Update();
  vtkSMPTools::Initialize(4);
  other->Update();
  vtkSMPTools::Initialize();
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Mesh there = Block(one, order[i]);
    const Mesh here = Block(other, i);
    EXPECT_EQ(LabelsOf(here), LabelsOf(there)) << i;
    EXPECT_EQ(ConfidenceOf(here), ConfidenceOf(there)) << i;
  }
}

TEST(CollectionTransfer, ACorrectedLabelIsHeardByTheOthers)
{
  vtkNew<vtkCollectionTransfer> collection;
  auto blocks = Collection({ 0, 1, 2 });
  collection->SetInputDataObject(blocks);
  collection->Update();
  // A second labelled mesh, which has a segment of its own in the place of the head.
  auto corrected = Mesh::New();
  corrected->ShallowCopy(Bipeds()[1]);
  std::vector<int> labels = LabelsOf(corrected);
  std::replace(labels.begin(), labels.end(), 2, 9);
  SetIntArray(corrected->GetCellData(), names::SegmentId, labels);
  auto withoutHead = Mesh::New();
  withoutHead->ShallowCopy(Bipeds()[0]);
  labels = LabelsOf(withoutHead);
  std::replace(labels.begin(), labels.end(), 2, 9);
  SetIntArray(withoutHead->GetCellData(), names::SegmentId, labels);
  blocks->SetBlock(0, withoutHead);
  blocks->SetBlock(1, corrected);
  collection->Update();
  labels = LabelsOf(Block(collection, 2));
  EXPECT_GT(std::count(labels.begin(), labels.end(), 9), 0);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 2), 0);

  vtkNew<vtkCollectionTransfer> anew;
  anew->SetInputDataObject(blocks);
  anew->Update();
  EXPECT_EQ(LabelsOf(Block(anew, 2)), labels);
}

TEST(CollectionTransfer, FilesRememberPairs)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / "marrow-collection-pairs";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto run = [&](const std::vector<int>& order)
  {
    vtkNew<vtkCollectionTransfer> collection;
    collection->SetInputDataObject(Collection(order));
    collection->SetCacheFolder(folder.c_str());
    collection->Update();
    return LabelsOf(Block(collection, 1));
  };
  const std::vector<int> labels = run({ 0, 1, 2 });
  const auto files = [&]()
  {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
      paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
  };
  ASSERT_EQ(files().size(), 3u);
  const auto written = std::filesystem::last_write_time(files()[0]);
  EXPECT_EQ(run({ 0, 1, 2 }), labels);
  EXPECT_EQ(std::filesystem::last_write_time(files()[0]), written);

  // One cut short, one of noise, one empty: they are as good as none, and are written again.
  std::filesystem::resize_file(files()[0], std::filesystem::file_size(files()[0]) / 2);
  {
    std::fstream noise(files()[1], std::ios::in | std::ios::out | std::ios::binary);
    noise.seekp(60);
    noise << std::string(4000, '\xff');
  }
  std::filesystem::resize_file(files()[2], 0);
  EXPECT_EQ(run({ 0, 1, 2 }), labels);
  EXPECT_EQ(run({ 0, 1, 2 }), labels);
  std::filesystem::remove_all(folder);
}

TEST(CollectionTransfer, ABadMeshDoesNotStopTheRest)
{
  vtkNew<vtkUnstructuredGrid> grid;
  auto broken = Mesh::New();
  broken->DeepCopy(Unlabelled(Bipeds()[1]));
  broken->GetPoints()->SetPoint(7, std::nan(""), 0.0, 0.0);
  auto noInteger = Mesh::New();
  noInteger->ShallowCopy(Unlabelled(Bipeds()[2]));
  SetArray(noInteger->GetCellData(), names::SegmentId,
    std::vector<double>(noInteger->GetNumberOfCells(), 0.5));
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(
    Blocks({ Bipeds()[0], grid.Get(), broken, noInteger, Mesh::New(), Unlabelled(Bipeds()[3]) }));
  ErrorObserver errors(collection);
  collection->Update();
  EXPECT_TRUE(errors.Errors.empty()) << errors.Text();
  EXPECT_TRUE(errors.HasWarning("mesh 1: it is a vtkUnstructuredGrid")) << errors.Text();
  EXPECT_TRUE(errors.HasWarning("mesh 2: ")) << errors.Text();
  EXPECT_TRUE(errors.HasWarning("mesh 3: ")) << errors.Text();
  EXPECT_TRUE(errors.HasWarning("mesh 4: ")) << errors.Text();
  EXPECT_EQ(Block(collection, 2), broken);
  EXPECT_FALSE(Block(collection, 2)->GetCellData()->HasArray(names::SegmentId));
  EXPECT_GE(Accuracy(Block(collection, 5), Bipeds()[3]), 0.9);
  EXPECT_EQ(Table(collection)->GetNumberOfRows(), 6);
  EXPECT_FALSE(Table(collection)->GetValueByName(2, "Note").ToString().empty());
}

TEST(CollectionTransfer, NothingLabelledIsAnError)
{
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(Collection({ 1, 2 }));
  ErrorObserver errors(collection);
  collection->Update();
  EXPECT_TRUE(errors.HasError("No mesh of the collection has the cell array \"SegmentId\""))
    << errors.Text();
  errors.Clear();
  collection->SetInputDataObject(Collection({ 0, 1 }));
  collection->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Parts");
  collection->Update();
  EXPECT_TRUE(errors.HasError("\"Parts\"")) << errors.Text();
}

TEST(CollectionTransfer, AnyTreeOfDatasets)
{
  vtkNew<vtkPartitionedDataSetCollection> tree;
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPartitionedDataSet> partition;
    partition->SetPartition(0, i == 0 ? Bipeds()[0] : Unlabelled(Bipeds()[1]));
    tree->SetPartitionedDataSet(i, partition);
  }
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(tree);
  collection->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(collection->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  auto* labelled = vtkPolyData::SafeDownCast(output->GetPartition(1, 0));
  ASSERT_TRUE(labelled);
  EXPECT_GE(Accuracy(labelled, Bipeds()[1]), 0.9);
}

TEST(CollectionTransfer, AnAbortIsFeltAndForgotten)
{
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(Collection({ 0, 1, 2 }));
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(caller);
      if (filter->GetProgress() > 0.3)
      {
        filter->SetAbortExecute(1);
      }
    });
  const unsigned long observer = collection->AddObserver(vtkCommand::ProgressEvent, abort);
  collection->Update();
  // Pairs that are under way on other threads may end; what comes after them does not begin.
  EXPECT_LE(collection->GetProgress(), 0.6);
  collection->RemoveObserver(observer);
  collection->SetAbortExecute(0);
  collection->Modified();
  collection->Update();
  EXPECT_GE(Accuracy(Block(collection, 1), Bipeds()[1]), 0.9);
}
