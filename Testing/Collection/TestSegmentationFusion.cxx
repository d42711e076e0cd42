// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "LabelVotes.h"
#include "TestMeshes.h"
#include "vtkSegmentationFusion.h"
#include "vtkSegmentationTransfer.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace marrow;
using namespace marrow::test;

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

std::vector<double> CellValues(vtkPolyData* mesh, const char* name)
{
  std::vector<double> values;
  GetArray(mesh->GetCellData(), name, static_cast<int>(mesh->GetNumberOfCells()), values);
  return values;
}

const Mesh& Quadruped()
{
  static const Mesh mesh = MakeCreature(vtkCreatureSource::QUADRUPED).Mesh;
  return mesh;
}

/// The quadruped with other labels.
Mesh With(const std::vector<int>& labels)
{
  auto mesh = Mesh::New();
  mesh->ShallowCopy(Quadruped());
  SetIntArray(mesh->GetCellData(), names::SegmentId, labels);
  return mesh;
}

/// The quadruped with some segments exchanged.
Mesh Exchanged(int a, int b)
{
  std::vector<int> labels = LabelsOf(Quadruped());
  for (int& label : labels)
  {
    label = label == a ? b : label == b ? a : label;
  }
  return With(labels);
}

/// The share of the faces that have the label of the quadruped: along boundaries the cut may move a few.
double Agreement(const Mesh& mesh)
{
  const std::vector<int> truth = LabelsOf(Quadruped());
  const std::vector<int> labels = LabelsOf(mesh);
  double same = 0.0;
  for (std::size_t f = 0; f < truth.size(); ++f)
  {
    same += truth[f] == labels.at(f) ? 1.0 : 0.0;
  }
  return same / static_cast<double>(truth.size());
}

void SetCost(vtkPolyData* mesh, double value)
{
  vtkNew<vtkDoubleArray> cost;
  cost->SetName(names::MatchingCost);
  cost->InsertNextValue(value);
  mesh->GetFieldData()->AddArray(cost);
}

Mesh Fuse(const std::vector<Mesh>& labellings, bool estimateTrust = false)
{
  vtkNew<vtkSegmentationFusion> fusion;
  for (const Mesh& labelling : labellings)
  {
    fusion->AddInputDataObject(0, labelling);
  }
  fusion->SetEstimateTrust(estimateTrust);
  ErrorObserver errors(fusion);
  fusion->Update();
  EXPECT_TRUE(errors.Text().empty()) << errors.Text();
  return fusion->GetOutput();
}
}

TEST(SegmentationFusion, WhatAllSayIsKept)
{
  // Noise too: nobody asked for it to be mended.
  std::vector<int> labels = LabelsOf(Quadruped());
  for (std::size_t f = 0; f < labels.size(); f += 37)
  {
    labels[f] = -5;
  }
  const Mesh fused = Fuse({ With(labels), With(labels), With(labels) });
  EXPECT_EQ(LabelsOf(fused), labels);
  for (const double value : CellValues(fused, names::SegmentDisagreement))
  {
    EXPECT_NEAR(value, 0.0, 1e-6);
  }
}

TEST(SegmentationFusion, TheMajorityWins)
{
  const std::vector<int> truth = LabelsOf(Quadruped());
  // Head for neck, a front leg for the other, two hind legs exchanged.
  const Mesh fused = Fuse({ Exchanged(1, 2), Exchanged(3, 4), Exchanged(5, 6) });
  EXPECT_GE(Agreement(fused), 0.95);
  const std::vector<double> disagreement = CellValues(fused, names::SegmentDisagreement);
  const std::vector<double> confidence = CellValues(fused, names::SegmentConfidence);
  vtkDataArray* shares = fused->GetCellData()->GetArray(names::SegmentShares);
  vtkDataArray* ids = fused->GetFieldData()->GetArray(names::SegmentShareId);
  ASSERT_EQ(shares->GetNumberOfComponents(), 8);
  ASSERT_EQ(ids->GetNumberOfTuples(), 8);
  for (std::size_t f = 0; f < truth.size(); ++f)
  {
    const bool isAgreed = truth[f] == 0 || truth[f] == 7;
    EXPECT_NEAR(disagreement[f], isAgreed ? 0.0 : 1.0 - 5.0 / 9.0, 1e-6);
    EXPECT_GE(confidence[f], 0.0);
    EXPECT_LE(confidence[f], 1.0);
    for (int k = 0; k < 8; ++k)
    {
      if (static_cast<int>(ids->GetTuple1(k)) == truth[f])
      {
        EXPECT_NEAR(
          shares->GetComponent(static_cast<vtkIdType>(f), k), isAgreed ? 1.0 : 2.0 / 3.0, 1e-6);
      }
    }
  }
}

TEST(SegmentationFusion, CostAndConfidenceWeigh)
{
  const std::vector<int> truth = LabelsOf(Quadruped());
  const Mesh good = With(truth);
  SetCost(good, 0.1);
  const Mesh bad = Exchanged(3, 4);
  SetCost(bad, 0.4);
  EXPECT_GE(Agreement(Fuse({ bad, good })), 0.95);
  EXPECT_GE(Agreement(Fuse({ bad, good, bad })), 0.95); // exp(-0.8) against twice exp(-3.2)
  const Mesh unsure = Exchanged(3, 4);
  SetArray(unsure->GetCellData(), names::SegmentConfidence, std::vector<double>(truth.size(), 0.2));
  EXPECT_GE(Agreement(Fuse({ unsure, With(truth) })), 0.95);
  const Mesh fused = Fuse({ bad, good });
  vtkDataArray* weights = fused->GetFieldData()->GetArray(names::LabellingWeight);
  ASSERT_EQ(weights->GetNumberOfTuples(), 2);
  EXPECT_NEAR(weights->GetTuple1(0), std::exp(-2.4), 1e-9);
  EXPECT_EQ(weights->GetTuple1(1), 1.0);
}

TEST(SegmentationFusion, TheOrderDecidesNothing)
{
  const std::vector<Mesh> labellings{ Exchanged(1, 2), Exchanged(1, 3), With(LabelsOf(Quadruped())),
    Exchanged(4, 6) };
  std::vector<Mesh> turned(labellings.rbegin(), labellings.rend());
  for (const bool estimateTrust : { false, true })
  {
    const Mesh one = Fuse(labellings, estimateTrust);
    const Mesh other = Fuse(turned, estimateTrust);
    EXPECT_EQ(LabelsOf(one), LabelsOf(other));
    EXPECT_EQ(
      CellValues(one, names::SegmentConfidence), CellValues(other, names::SegmentConfidence));
  }
}

TEST(SegmentationFusion, TrustIsEstimatedFromAgreement)
{
  // Three are mostly right, each wrong elsewhere; one is right nowhere.
  const std::vector<int> truth = LabelsOf(Quadruped());
  std::vector<int> nonsense(truth.size(), 0);
  for (std::size_t f = 0; f < truth.size(); ++f)
  {
    nonsense[f] = 7 - truth[f];
  }
  std::vector<Labelling> labellings;
  for (const Mesh& mesh : { Exchanged(1, 2), Exchanged(3, 4), Exchanged(5, 6) })
  {
    labellings.push_back({ LabelsOf(mesh), {}, 1.0 });
  }
  labellings.push_back({ nonsense, {}, 1.0 });
  const std::vector<double> rates =
    WeighByTrust(std::vector<double>(truth.size(), 1.0), labellings);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_GT(rates[k], 0.7);
    EXPECT_GT(labellings[k].Weight, 2.0);
  }
  EXPECT_LT(rates[3], 0.1);
  EXPECT_EQ(labellings[3].Weight, 0.0);
  EXPECT_GE(
    Agreement(Fuse({ Exchanged(1, 2), With(nonsense), Exchanged(3, 4), Exchanged(5, 6) }, true)),
    0.95);
}

TEST(SegmentationFusion, TransfersAreFused)
{
  vtkNew<vtkSegmentationFusion> fusion;
  std::vector<vtkSmartPointer<vtkSegmentationTransfer>> transfers;
  for (int seed = 2; seed < 5; ++seed)
  {
    CreatureOptions options;
    options.Seed = seed;
    options.Pose = 0.5;
    options.Proportion = 0.5;
    transfers.push_back(vtkSmartPointer<vtkSegmentationTransfer>::New());
    transfers.back()->SetInputData(0, MakeCreature(vtkCreatureSource::QUADRUPED, options).Mesh);
    transfers.back()->SetInputData(1, Quadruped());
    fusion->AddInputConnection(0, transfers.back()->GetOutputPort(0));
  }
  fusion->Update();
  EXPECT_GT(Agreement(fusion->GetOutput()), 0.95);
  vtkDataArray* cost =
    transfers[0]->GetOutputDataObject(0)->GetFieldData()->GetArray(names::MatchingCost);
  ASSERT_TRUE(cost);
  EXPECT_GT(cost->GetTuple1(0), 0.0);
  EXPECT_LT(cost->GetTuple1(0), 0.5);
}

TEST(SegmentationFusion, WhatCannotBeFusedIsNamed)
{
  const auto errorOf = [](const Mesh& second)
  {
    vtkNew<vtkSegmentationFusion> fusion;
    fusion->AddInputDataObject(0, Quadruped());
    fusion->AddInputDataObject(0, second);
    ErrorObserver errors(fusion);
    fusion->Update();
    return errors.Text();
  };
  const Mesh other = MakeCreature(vtkCreatureSource::SNAKE).Mesh;
  EXPECT_NE(errorOf(other).find("Labelling 1: it has "), std::string::npos) << errorOf(other);
  auto without = Mesh::New();
  without->ShallowCopy(Quadruped());
  without->GetCellData()->RemoveArray(names::SegmentId);
  EXPECT_NE(errorOf(without).find("Labelling 1: the mesh has no cell array \"SegmentId\""),
    std::string::npos)
    << errorOf(without);
  const Mesh notFinite = With(LabelsOf(Quadruped()));
  std::vector<double> confidence(Quadruped()->GetNumberOfCells(), 1.0);
  confidence[3] = std::nan("");
  SetArray(notFinite->GetCellData(), names::SegmentConfidence, confidence);
  EXPECT_NE(errorOf(notFinite).find("not finite"), std::string::npos) << errorOf(notFinite);
}
