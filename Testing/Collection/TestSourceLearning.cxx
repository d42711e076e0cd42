// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "LabelForest.h"
#include "PairSelection.h"
#include "SourceLearning.h"
#include "TestMeshes.h"
#include "vtkCollectionTransfer.h"

#include <vtkCellData.h>
#include <vtkMSPField.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

using namespace marrow;
using namespace marrow::test;

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

constexpr int NumberOfMeshes = 5;
constexpr int NumberOfSources = 3; // the first ones

/// Bipeds of different poses and proportions.
const std::vector<Mesh>& Bipeds()
{
  static std::vector<Mesh> meshes;
  for (int seed = 1; meshes.size() < NumberOfMeshes; ++seed)
  {
    CreatureOptions options;
    options.Seed = seed;
    options.Pose = 0.6;
    options.Proportion = 0.6;
    options.Faces = 2500;
    meshes.push_back(MakeCreature(vtkCreatureSource::BIPED, options).Mesh);
  }
  return meshes;
}

std::vector<std::vector<int>> LabelsOfParts()
{
  std::vector<std::vector<int>> labels;
  for (const Mesh& mesh : Bipeds())
  {
    labels.push_back(LabelsOf(mesh));
  }
  return labels;
}

/// MSP per face, over the root of the area.
std::vector<double> ThicknessOfFaces(vtkPolyData* mesh)
{
  vtkNew<vtkMSPField> field;
  field->SetInputData(mesh);
  field->Update();
  std::vector<double> perimeters;
  GetArray(field->GetOutput()->GetPointData(), names::MSP,
    static_cast<int>(mesh->GetNumberOfPoints()), perimeters);
  TriangleMesh triangles;
  ToTriangleMesh(mesh, triangles);
  const std::vector<double> areas = triangles.TriangleAreas();
  const double size = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.0));
  std::vector<double> thickness;
  for (const auto& [a, b, c] : triangles.Triangles)
  {
    thickness.push_back((perimeters[a] + perimeters[b] + perimeters[c]) / (3.0 * size));
  }
  return thickness;
}

/// 1 where a mesh is thicker than half of the first one is: no correspondence tells, as proportions differ, but
/// the measures do.
std::vector<std::vector<int>> LabelsOfThickness()
{
  std::vector<double> ofFirst = ThicknessOfFaces(Bipeds()[0]);
  std::sort(ofFirst.begin(), ofFirst.end());
  const double limit = ofFirst[ofFirst.size() / 2];
  std::vector<std::vector<int>> labels;
  for (const Mesh& mesh : Bipeds())
  {
    labels.emplace_back();
    for (const double thickness : ThicknessOfFaces(mesh))
    {
      labels.back().push_back(thickness > limit ? 1 : 0);
    }
  }
  return labels;
}

/// The bipeds, those of the sources labelled, from the block `first` on.
vtkSmartPointer<vtkMultiBlockDataSet> Blocks(
  const std::vector<std::vector<int>>& labels, int first = 0)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (int i = 0; i < NumberOfMeshes; ++i)
  {
    const Mesh& biped = Bipeds()[i];
    auto mesh = Mesh::New();
    mesh->SetPoints(biped->GetPoints());
    mesh->SetPolys(biped->GetPolys());
    if (i < NumberOfSources)
    {
      SetIntArray(mesh->GetCellData(), names::SegmentId, labels[i]);
    }
    blocks->SetBlock(static_cast<unsigned int>((first + i) % NumberOfMeshes), mesh);
  }
  return blocks;
}

std::vector<int> LabelsOfBlock(vtkCollectionTransfer* filter, int block)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return LabelsOf(
    vtkPolyData::SafeDownCast(blocks->GetBlock(static_cast<unsigned int>(block % NumberOfMeshes))));
}

/// Of the faces of the meshes that were not labelled.
double Accuracy(vtkCollectionTransfer* filter, const std::vector<std::vector<int>>& truth)
{
  double same = 0.0;
  double total = 0.0;
  for (int i = NumberOfSources; i < NumberOfMeshes; ++i)
  {
    const std::vector<int> labels = LabelsOfBlock(filter, i);
    for (std::size_t t = 0; t < labels.size(); ++t)
    {
      same += labels[t] == truth[i][t] ? 1.0 : 0.0;
    }
    total += static_cast<double>(labels.size());
  }
  return same / total;
}

double Value(vtkCollectionTransfer* filter, int row, const char* column)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(1))
    ->GetValueByName(row, column)
    .ToDouble();
}
}

TEST(LabelForest, TellsLabelsByTheirFeatures)
{
  // Three labels by two features, one of which is noise; the label 2 is not there.
  constexpr int size = 400;
  Eigen::MatrixXf features(size, 2);
  std::vector<int> columns;
  for (int i = 0; i < size; ++i)
  {
    features.row(i) << static_cast<float>(i) / size, static_cast<float>(i * 7919 % 101);
    columns.push_back(i < size / 4 ? 0 : i < size / 2 ? 3 : 1);
  }
  const LabelForest forest(features, columns, 4);
  const LabelShares shares = forest.Predict(features);
  int wrong = 0;
  for (int i = 0; i < size; ++i)
  {
    Eigen::Index column = 0;
    shares.row(i).maxCoeff(&column);
    wrong += column != columns[i] ? 1 : 0;
    EXPECT_NEAR(shares.row(i).sum(), 1.0f, 1e-5f);
    EXPECT_EQ(shares(i, 2), 0.0f);
  }
  EXPECT_LE(wrong, size / 50);
  EXPECT_EQ(LabelForest(features, columns, 4).Predict(features), shares);
}

TEST(SourceLearning, MeshesToHoldOutAreFewAndSpread)
{
  EXPECT_TRUE(MeshesToHoldOut({ 4, 4, 5, 6 }, { true, true, true, false }).empty());
  EXPECT_EQ(MeshesToHoldOut({ 4, 4, 5, 6 }, { true, true, true, true }).size(), 3u);
  std::vector<int> meshes;
  for (int mesh = 0; mesh < 100; ++mesh)
  {
    meshes.push_back(mesh);
  }
  const std::vector<int> chosen = MeshesToHoldOut(meshes, std::vector<bool>(meshes.size(), true));
  EXPECT_EQ(std::set<int>(chosen.begin(), chosen.end()).size(), 8u);
  EXPECT_GE(chosen.back(), 80);
}

TEST(SourceLearning, WhatTheSurfaceTellsIsLearnt)
{
  const std::vector<std::vector<int>> truth = LabelsOfThickness();
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(Blocks(truth));
  collection->LearnFromSourcesOff();
  collection->Update();
  const double byVote = Accuracy(collection, truth);
  EXPECT_EQ(Value(collection, 3, "Learning"), 0.0);
  EXPECT_TRUE(std::isnan(Value(collection, 0, "HeldOutAccuracy")));
  collection->LearnFromSourcesOn();
  collection->Update();
  EXPECT_GT(Value(collection, 3, "Learning"), 0.0);
  EXPECT_GT(Accuracy(collection, truth), byVote + 0.02);
  for (int i = 0; i < NumberOfSources; ++i)
  {
    EXPECT_GT(
      Value(collection, i, "HeldOutAccuracyLearnt"), Value(collection, i, "HeldOutAccuracy"));
    EXPECT_EQ(LabelsOfBlock(collection, i), truth[i]);
  }
  EXPECT_TRUE(std::isnan(Value(collection, 3, "HeldOutAccuracy")));
}

TEST(SourceLearning, LabelsThatAreHeldBackAreNotSeen)
{
  // What one mesh calls 1 the others call 2, and the other way round: with its labels seen it would do well.
  std::vector<std::vector<int>> labels = LabelsOfParts();
  const int most = *std::max_element(labels[2].begin(), labels[2].end());
  for (int& label : labels[2])
  {
    label = most - label;
  }
  vtkNew<vtkCollectionTransfer> collection;
  collection->SetInputDataObject(Blocks(labels));
  collection->Update();
  EXPECT_GT(Value(collection, 0, "HeldOutAccuracy"), 0.8);
  EXPECT_LT(Value(collection, 2, "HeldOutAccuracy"), 0.6);
  EXPECT_LT(Value(collection, 2, "HeldOutAccuracyLearnt"), 0.6);
  EXPECT_EQ(Value(collection, 3, "Learning"), 0.0); // one of the three teaches what is wrong
}

TEST(SourceLearning, NeitherOrderNorThreadsDecide)
{
  const std::vector<std::vector<int>> truth = LabelsOfThickness();
  vtkNew<vtkCollectionTransfer> one;
  one->SetInputDataObject(Blocks(truth));
  vtkNew<vtkCollectionTransfer> other;
  other->SetInputDataObject(Blocks(truth, 2));
  vtkSMPTools::Initialize(1);
  one->Update();
  vtkSMPTools::Initialize(4);
  other->Update();
  vtkSMPTools::Initialize();
  for (int i = 0; i < NumberOfMeshes; ++i)
  {
    EXPECT_EQ(LabelsOfBlock(one, i), LabelsOfBlock(other, i + 2)) << i;
  }
  EXPECT_EQ(Value(one, 0, "HeldOutAccuracyLearnt"), Value(other, 2, "HeldOutAccuracyLearnt"));
}
