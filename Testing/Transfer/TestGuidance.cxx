// SPDX-License-Identifier: BSD-3-Clause
// What the user says about a transfer: hints, which answer, which segments.
#include "ErrorObserver.h"
#include "TransferTestData.h"

#include <vtkPointData.h>
#include <vtkSkeletonCorrespondence.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

using namespace marrow;
using namespace marrow::test;

namespace
{
const Prepared& Target()
{
  return Quadruped(2, 0.5, 0.5, 6000);
}

/// The point nearest to the middle of a segment among those of its faces.
Eigen::Vector3d MiddleOf(vtkPolyData* mesh, int segment)
{
  TriangleMesh triangles;
  ToTriangleMesh(mesh, triangles);
  const std::vector<int> labels = LabelsOf(mesh);
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    if (labels[t] == segment)
    {
      for (const int corner : triangles.Triangles[t])
      {
        corners.push_back(triangles.Points[corner]);
        middle += triangles.Points[corner];
      }
    }
  }
  middle /= static_cast<double>(corners.size());
  return *std::min_element(corners.begin(), corners.end(),
    [&](const auto& a, const auto& b) { return (a - middle).norm() < (b - middle).norm(); });
}

Data PointsAt(const std::vector<Eigen::Vector3d>& positions, bool isForbidden = false)
{
  auto data = Data::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkUnsignedCharArray> forbidden;
  forbidden->SetName(names::Forbidden);
  for (const Eigen::Vector3d& position : positions)
  {
    points->InsertNextPoint(position.data());
    forbidden->InsertNextValue(isForbidden ? 1 : 0);
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(forbidden);
  return data;
}

/// A pair of segments, of the source and of the target, that correspond or must not.
struct Pair
{
  int Source;
  int Target;
  bool IsForbidden = false;
};

void Hint(vtkAlgorithm* filter, int firstPort, const Pair& pair)
{
  filter->SetInputDataObject(
    firstPort, PointsAt({ MiddleOf(Source().Mesh, pair.Source) }, pair.IsForbidden));
  filter->SetInputDataObject(firstPort + 1, PointsAt({ MiddleOf(Target().Mesh, pair.Target) }));
}

/// The share of a segment of the target that has got a label.
double Share(const std::vector<int>& labels, int segment, int label)
{
  const std::vector<int> truth = LabelsOf(Target().Mesh);
  double size = 0.0;
  double got = 0.0;
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    size += truth[t] == segment ? 1.0 : 0.0;
    got += truth[t] == segment && labels[t] == label ? 1.0 : 0.0;
  }
  return got / size;
}

std::vector<int> LabelsWith(const Pair& pair)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, Source().Mesh);
  transfer->SetInputData(1, Target().Mesh);
  Hint(transfer, 4, pair);
  transfer->Update();
  return LabelsOf(Output(transfer));
}

/// Per segment of the target the label that most of its faces get.
std::map<int, int> MostFrequent(const std::vector<int>& labels)
{
  const std::vector<int> truth = LabelsOf(Target().Mesh);
  std::map<int, std::map<int, int>> counts;
  for (std::size_t t = 0; t < truth.size(); ++t)
  {
    ++counts[truth[t]][labels[t]];
  }
  std::map<int, int> most;
  for (const auto& [segment, ofSegment] : counts)
  {
    most[segment] = std::max_element(ofSegment.begin(), ofSegment.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  }
  return most;
}

/// Segments of the creatures: torso, neck, head, four legs, tail.
std::vector<int> Limbs()
{
  const std::vector<int> labels = LabelsOf(Source().Mesh);
  const std::set<int> segments(labels.begin(), labels.end());
  return { segments.begin(), segments.end() };
}
}

TEST(Guidance, AHintOnOnePartTurnsTheWholeRound)
{
  const std::vector<int> plain = LabelsWith({ 2, 2 });
  for (const int segment : Limbs())
  {
    EXPECT_EQ(MostFrequent(plain)[segment], segment);
  }
  // The last segment is the tail, the third the head.
  const int head = 2;
  const int tail = Limbs().back();
  const std::vector<int> turned = LabelsWith({ head, tail });
  EXPECT_GT(Share(turned, tail, head), 0.5);
  EXPECT_LT(Share(turned, head, head), 0.1);
}

TEST(Guidance, AForbiddenPairIsNotMatched)
{
  for (const int leg : { 3, 5 })
  {
    EXPECT_LT(Share(LabelsWith({ leg, leg, true }), leg, leg), 0.1) << "leg " << leg;
  }
}

TEST(Guidance, SkeletonsTakeHintsToo)
{
  vtkNew<vtkSkeletonCorrespondence> correspondence;
  correspondence->SetInputData(0, Source().Skeleton);
  correspondence->SetInputData(1, Target().Skeleton);
  const auto idOfTerminalNear = [&](int side, const Eigen::Vector3d& point)
  {
    auto* skeleton = vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(side));
    double least = std::numeric_limits<double>::infinity();
    double id = -1.0;
    for (vtkIdType i = 0; i < skeleton->GetNumberOfPoints(); ++i)
    {
      const Eigen::Vector3d at(skeleton->GetPoint(i));
      const double value =
        skeleton->GetPointData()->GetArray(names::CorrespondenceId)->GetTuple1(i);
      const bool isTerminal =
        skeleton->GetPointData()->GetArray(names::NodeType)->GetTuple1(i) == 1.0;
      if (isTerminal && (at - point).norm() < least)
      {
        least = (at - point).norm();
        id = value;
      }
    }
    return id;
  };
  const int leg = 3;
  const int other = 5;
  Hint(correspondence, 2, { leg, other });
  correspondence->Update();
  EXPECT_EQ(idOfTerminalNear(0, MiddleOf(Source().Mesh, leg)),
    idOfTerminalNear(1, MiddleOf(Target().Mesh, other)));
  correspondence->RemoveSourceHints();
  correspondence->RemoveTargetHints();
  correspondence->Update();
  EXPECT_EQ(idOfTerminalNear(0, MiddleOf(Source().Mesh, leg)),
    idOfTerminalNear(1, MiddleOf(Target().Mesh, leg)));
}

TEST(Guidance, HintsThatContradictEachOtherAreWarnedOf)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, Source().Mesh);
  transfer->SetInputData(1, Target().Mesh);
  const Eigen::Vector3d head = MiddleOf(Source().Mesh, 2);
  transfer->SetInputData(4, PointsAt({ head, head }));
  transfer->SetInputData(
    5, PointsAt({ MiddleOf(Target().Mesh, 2), MiddleOf(Target().Mesh, Limbs().back()) }));
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasWarning("1 of 2 are contradicted")) << errors.Text();
}

TEST(Guidance, HintsOfUnequalNumberAreRefused)
{
  for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(vtkSegmentationTransfer::New()),
         static_cast<vtkAlgorithm*>(vtkSkeletonCorrespondence::New()) })
  {
    const bool ofMeshes = filter->GetNumberOfInputPorts() == 6;
    filter->SetInputDataObject(0, ofMeshes ? Source().Mesh : Source().Skeleton);
    filter->SetInputDataObject(1, ofMeshes ? Target().Mesh : Target().Skeleton);
    filter->SetInputDataObject(ofMeshes ? 4 : 2, PointsAt({ Eigen::Vector3d::Zero() }));
    ErrorObserver errors(filter);
    filter->Update();
    EXPECT_TRUE(errors.HasError("1 points on the source and 0 on the target")) << errors.Text();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    filter->SetInputDataObject(ofMeshes ? 5 : 3, PointsAt({ Eigen::Vector3d::Constant(nan) }));
    errors.Clear();
    filter->Update();
    EXPECT_TRUE(errors.HasError("Hints: point 0 is not finite")) << errors.Text();
    filter->Delete();
  }
}

TEST(Guidance, AnswersAreTakenByTheirRank)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, Source().Mesh);
  transfer->SetInputData(1, Target().Mesh);
  transfer->Update();
  const std::vector<int> best = LabelsOf(Output(transfer));
  // One of the next may be that of the meshes as wholes, which brings the same segments to the limbs.
  bool isOther = false;
  for (const int index : { 1, 2 })
  {
    transfer->SetAnswerIndex(index);
    transfer->Update();
    isOther = isOther || MostFrequent(LabelsOf(Output(transfer))) != MostFrequent(best);
  }
  EXPECT_TRUE(isOther);
  transfer->SetAnswerIndex(1000);
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasError("AnswerIndex is 1000, but the number of answers is"))
    << errors.Text();
}

TEST(Guidance, OnlyTheChosenSegmentsAreCarried)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, Source().Mesh);
  transfer->SetInputData(1, Target().Mesh);
  transfer->Update();
  std::vector<int> expected = LabelsOf(Output(transfer));
  for (int& label : expected)
  {
    label = label == 2 || label == 3 ? label : -1;
  }
  transfer->AddCarriedSegment(2);
  transfer->AddCarriedSegment(3);
  transfer->Update();
  EXPECT_EQ(LabelsOf(Output(transfer)), expected);
  transfer->RemoveAllCarriedSegments();
  transfer->Update();
  EXPECT_EQ(MostFrequent(LabelsOf(Output(transfer)))[5], 5);
}

TEST(Guidance, SegmentsOfTheTargetAreKept)
{
  // The head is somebody's own, and so is a number that the source has not got; the rest is open.
  const std::vector<int> truth = LabelsOf(Target().Mesh);
  std::vector<int> own(truth.size(), -1);
  for (std::size_t t = 0; t < truth.size(); ++t)
  {
    own[t] = truth[t] == 2 ? 4 : truth[t] == 3 ? 77 : -1;
  }
  auto mesh = Data::New();
  mesh->ShallowCopy(Target().Mesh);
  SetIntArray(mesh->GetCellData(), names::SegmentId, own);
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, Source().Mesh);
  transfer->SetInputData(1, mesh);
  transfer->KeepTargetSegmentsOn();
  ErrorObserver errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.HasWarning("missing altogether: 2, 3")) << errors.Text();
  const Data output = Output(transfer);
  const std::vector<int> labels = LabelsOf(output);
  for (std::size_t t = 0; t < own.size(); ++t)
  {
    if (own[t] >= 0)
    {
      ASSERT_EQ(labels[t], own[t]) << "face " << t;
      ASSERT_EQ(output->GetCellData()
                  ->GetArray(names::SegmentConfidence)
                  ->GetTuple1(static_cast<vtkIdType>(t)),
        1.0);
    }
  }
  EXPECT_EQ(MostFrequent(labels)[5], 5);

  mesh->GetCellData()->RemoveArray(names::SegmentId);
  mesh->Modified();
  transfer->Update();
  EXPECT_TRUE(errors.HasError("Target: the mesh has no cell array \"SegmentId\"")) << errors.Text();
}
