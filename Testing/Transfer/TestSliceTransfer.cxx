// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of revolution with segments along the axis, carried to other proportions.
#include "RevolutionShapes.h"
#include "TransferTestData.h"

#include <Eigen/Geometry>

#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

using namespace marrow;
using namespace marrow::test;

namespace
{
Data ToData(const Labelled& shape)
{
  Data data = ToPolyData(shape.Mesh);
  SetIntArray(data->GetCellData(), names::SegmentId, shape.Labels);
  return data;
}

/// The share of the target's area with the segment that it was made with, by slices.
double Accuracy(const Labelled& source, const Labelled& target)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, ToData(source));
  transfer->SetInputData(1, ToData(target));
  transfer->Update();
  auto* matchedBy = vtkStringArray::SafeDownCast(
    transfer->GetOutput()->GetFieldData()->GetAbstractArray(names::MatchedBy));
  EXPECT_TRUE(matchedBy && matchedBy->GetNumberOfValues() == 1);
  EXPECT_EQ(matchedBy->GetValue(0), "slices");
  vtkDataArray* labels = transfer->GetOutput()->GetCellData()->GetArray(names::SegmentId);
  double same = 0.0;
  double total = 0.0;
  for (int t = 0; t < target.Mesh.NumberOfTriangles(); ++t)
  {
    total += target.Mesh.Area(t);
    same += labels->GetTuple1(t) == target.Labels[t] ? target.Mesh.Area(t) : 0.0;
  }
  return same / total;
}
}

TEST(SliceTransfer, FootBellyNeckAndLipGoToOtherProportions)
{
  EXPECT_GT(Accuracy(Jug(), Bowl()), 0.95);
  EXPECT_GT(Accuracy(Bowl(), Jug()), 0.95);
}

TEST(SliceTransfer, AHandleGoesToAHandle)
{
  Labelled jug = Jug();
  AddHandle(jug, 1.0, 1.6, 0.5);
  Labelled bowl = Bowl();
  AddHandle(bowl, 1.3, 1.4, 0.5);
  bowl.Mesh = Rotated(bowl.Mesh, Eigen::Vector3d::UnitZ(), 1.9);
  bowl.Mesh.BuildConnectivity();
  EXPECT_GT(Accuracy(jug, bowl), 0.93);
}

TEST(SliceTransfer, StrictBoundariesKnowSkeletonsAlone)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, ToData(Jug()));
  transfer->SetInputData(1, ToData(Bowl()));
  transfer->StrictBoundariesOn();
  transfer->Update();
  auto* matchedBy = vtkStringArray::SafeDownCast(
    transfer->GetOutput()->GetFieldData()->GetAbstractArray(names::MatchedBy));
  ASSERT_TRUE(matchedBy);
  EXPECT_NE(matchedBy->GetValue(0), "slices");
}

TEST(SliceTransfer, UpsideDownAndScaledItIsTheSame)
{
  EXPECT_GT(Accuracy(Jug(), Moved(Bowl())), 0.95);
}
