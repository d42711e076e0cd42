// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "TestMeshes.h"
#include "vtkTimeSeriesTransfer.h"

#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace marrow;
using namespace marrow::test;

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

/// A biped that moves, and is meshed anew at every step.
Mesh Biped(int step)
{
  vtkNew<vtkCreatureSource> creature;
  creature->SetShapeToBiped();
  creature->SetPose(0.2 + 0.1 * step);
  creature->SetResolution(4000 + 500 * step);
  creature->Update();
  return creature->GetOutput();
}

/// Gives the bipeds at the times 0, 0.5, 1 and so on, one of them labelled if that is wanted.
class MovingBiped : public vtkPolyDataAlgorithm
{
public:
  static MovingBiped* New();
  vtkTypeMacro(MovingBiped, vtkPolyDataAlgorithm);

  std::vector<Mesh> Steps;
  int LabelledStep = -1;
  int NumberOfExecutions = 0;

protected:
  MovingBiped()
  {
    this->SetNumberOfInputPorts(0);
    for (int step = 0; step < 3; ++step)
    {
      this->Steps.push_back(Biped(step));
    }
  }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const double times[] = { 0.0, 0.5, 1.0 };
    vtkInformation* info = outputVector->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
    const double range[] = { times[0], times[2] };
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkInformation* info = outputVector->GetInformationObject(0);
    const int step =
      static_cast<int>(2.0 * info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()));
    vtkPolyData* output = vtkPolyData::GetData(info);
    output->ShallowCopy(this->Steps.at(step));
    if (step != this->LabelledStep)
    {
      output->GetCellData()->Initialize();
    }
    ++this->NumberOfExecutions;
    return 1;
  }
};
vtkStandardNewMacro(MovingBiped);

double ShareOfEqual(vtkPolyData* result, vtkPolyData* truth)
{
  const std::vector<int> labels = LabelsOf(result);
  const std::vector<int> right = LabelsOf(truth);
  EXPECT_EQ(labels.size(), right.size());
  int same = 0;
  for (std::size_t i = 0; i < std::min(labels.size(), right.size()); ++i)
  {
    same += labels[i] == right[i] ? 1 : 0;
  }
  return static_cast<double>(same) / static_cast<double>(right.size());
}
}

TEST(TimeSeriesTransfer, EveryStepIsLabelledFromOneMesh)
{
  vtkNew<MovingBiped> moving;
  vtkNew<vtkTimeSeriesTransfer> transfer;
  transfer->SetInputConnection(0, moving->GetOutputPort());
  transfer->SetInputData(1, Biped(5));
  ErrorObserver errors(transfer);
  for (const int step : { 2, 0, 1 })
  {
    transfer->UpdateTimeStep(0.5 * step);
    EXPECT_GE(ShareOfEqual(transfer->GetOutput(), moving->Steps[step]), 0.93) << step;
    EXPECT_TRUE(transfer->GetOutput()->GetCellData()->HasArray(names::SegmentConfidence));
    EXPECT_EQ(
      transfer->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 0.5 * step);
  }
  EXPECT_TRUE(errors.Text().empty()) << errors.Text();
  auto* table = vtkTable::SafeDownCast(transfer->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 4);
  EXPECT_EQ(table->GetValueByName(1, "Block").ToString(), "step 1");
  EXPECT_EQ(table->GetValueByName(1, "Source").ToString(), "labelled 0");
  // Times between the steps are those of the nearest.
  transfer->UpdateTimeStep(0.6);
  EXPECT_EQ(transfer->GetOutput()->GetNumberOfCells(), moving->Steps[1]->GetNumberOfCells());
}

TEST(TimeSeriesTransfer, AStepWithLabelsLabelsTheOthers)
{
  vtkNew<MovingBiped> moving;
  moving->LabelledStep = 1;
  vtkNew<vtkTimeSeriesTransfer> transfer;
  transfer->SetInputConnection(0, moving->GetOutputPort());
  transfer->UpdateTimeStep(0.5);
  EXPECT_EQ(LabelsOf(transfer->GetOutput()), LabelsOf(moving->Steps[1]));
  transfer->UpdateTimeStep(1.0);
  EXPECT_GE(ShareOfEqual(transfer->GetOutput(), moving->Steps[2]), 0.93);
}

TEST(TimeSeriesTransfer, StepsAreGoneThroughOnceUntilSomethingChanges)
{
  vtkNew<MovingBiped> moving;
  vtkNew<vtkTimeSeriesTransfer> transfer;
  transfer->SetInputConnection(0, moving->GetOutputPort());
  transfer->SetInputData(1, Biped(5));
  transfer->UpdateTimeStep(0.0);
  EXPECT_EQ(moving->NumberOfExecutions, 3);
  const std::vector<int> before = LabelsOf(transfer->GetOutput());
  transfer->UpdateTimeStep(0.5);
  transfer->UpdateTimeStep(0.0);
  // One for each time asked for, which a pipeline cannot do without.
  EXPECT_LE(moving->NumberOfExecutions, 5);
  EXPECT_EQ(LabelsOf(transfer->GetOutput()), before);

  // The labelled mesh gets another label for the head.
  const Mesh labelled = Biped(5);
  std::vector<int> labels = LabelsOf(labelled);
  std::replace(labels.begin(), labels.end(), 2, 9);
  SetIntArray(labelled->GetCellData(), names::SegmentId, labels);
  transfer->SetInputData(1, labelled);
  for (const double time : { 0.0, 1.0 })
  {
    transfer->UpdateTimeStep(time);
    labels = LabelsOf(transfer->GetOutput());
    EXPECT_EQ(std::count(labels.begin(), labels.end(), 2), 0) << time;
    EXPECT_GT(std::count(labels.begin(), labels.end(), 9), 0) << time;
  }
}

TEST(TimeSeriesTransfer, NothingLabelledIsAnErrorAndCanBeMended)
{
  vtkNew<MovingBiped> moving;
  vtkNew<vtkTimeSeriesTransfer> transfer;
  transfer->SetInputConnection(0, moving->GetOutputPort());
  ErrorObserver errors(transfer);
  transfer->UpdateTimeStep(0.0);
  EXPECT_TRUE(errors.HasError("has the cell array \"SegmentId\"")) << errors.Text();
  transfer->SetInputData(1, Biped(5));
  transfer->UpdateTimeStep(0.0);
  EXPECT_GE(ShareOfEqual(transfer->GetOutput(), moving->Steps[0]), 0.93);
}

TEST(TimeSeriesTransfer, AMeshWithoutTimeIsASeriesOfOneStep)
{
  const Mesh truth = Biped(0);
  auto bare = Mesh::New();
  bare->ShallowCopy(truth);
  bare->GetCellData()->Initialize();
  vtkNew<vtkTimeSeriesTransfer> transfer;
  transfer->SetInputData(0, bare);
  transfer->SetInputData(1, Biped(1));
  transfer->Update();
  EXPECT_GE(ShareOfEqual(transfer->GetOutput(), truth), 0.93);
}
