// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeSeriesTransfer.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "vtkCollectionTransfer.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTimeSeriesTransfer);

namespace
{
void AddBlock(vtkMultiBlockDataSet* blocks, vtkPolyData* mesh, const std::string& name)
{
  const unsigned int block = blocks->GetNumberOfBlocks();
  blocks->SetBlock(block, mesh);
  blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

/// The filter inside goes on as far as the one around it.
void PassProgress(vtkObject* caller, unsigned long, void* around, void*)
{
  auto* inside = static_cast<vtkAlgorithm*>(caller);
  auto* filter = static_cast<vtkAlgorithm*>(around);
  filter->UpdateProgress(inside->GetProgress());
  if (marrow::IsAborted(filter))
  {
    inside->SetAbortExecute(1);
  }
}
}

struct vtkTimeSeriesTransfer::Series
{
  std::vector<double> Times; ///< of the input's steps; one, of no meaning, if it has none
  std::vector<vtkSmartPointer<vtkPolyData>> Meshes; ///< those collected so far, then all
  vtkMTimeType Collected = 0; ///< as of which state of the inputs; 0: not at all
  vtkNew<vtkCollectionTransfer> Transfer;

  bool IsComplete() const { return this->Meshes.size() == this->Times.size(); }
};

vtkTimeSeriesTransfer::vtkTimeSeriesTransfer()
  : Steps(new Series)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
  vtkNew<vtkCallbackCommand> pass;
  pass->SetCallback(PassProgress);
  pass->SetClientData(this);
  this->Steps->Transfer->AddObserver(vtkCommand::ProgressEvent, pass);
}

vtkTimeSeriesTransfer::~vtkTimeSeriesTransfer()
{
  this->SetCacheFolder(nullptr);
}

int vtkTimeSeriesTransfer::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkTimeSeriesTransfer::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

void vtkTimeSeriesTransfer::RemoveLabelledMeshes()
{
  this->RemoveAllInputConnections(1);
}

bool vtkTimeSeriesTransfer::IsCurrent()
{
  vtkMTimeType now = this->GetMTime();
  for (int port = 0; port < 2; ++port)
  {
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      // Unlike the data's own, this time does not change with the step that is asked for.
      if (auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetInputExecutive(port, i)))
      {
        now = std::max(now, pipeline->GetPipelineMTime());
      }
    }
  }
  if (now == this->Steps->Collected)
  {
    return true;
  }
  this->Steps->Collected = now;
  return false;
}

int vtkTimeSeriesTransfer::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  const double* times = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  const int size = info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  std::vector<double> steps(times, times + (times ? size : 0));
  if (steps.empty())
  {
    steps.push_back(0.0);
  }
  if (!this->IsCurrent() || steps != this->Steps->Times)
  {
    this->Steps->Meshes.clear();
  }
  this->Steps->Times = std::move(steps);
  return 1;
}

int vtkTimeSeriesTransfer::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (!this->Steps->IsComplete() && info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
  {
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(),
      this->Steps->Times[this->Steps->Meshes.size()]);
  }
  return 1;
}

bool vtkTimeSeriesTransfer::Label(vtkInformationVector* labelled)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (std::size_t step = 0; step < this->Steps->Meshes.size(); ++step)
  {
    AddBlock(blocks, this->Steps->Meshes[step], "step " + std::to_string(step));
  }
  for (int i = 0; i < labelled->GetNumberOfInformationObjects(); ++i)
  {
    AddBlock(blocks, vtkPolyData::GetData(labelled, i), "labelled " + std::to_string(i));
  }
  const std::string name = marrow::NameOfSegments(this);
  bool isAnyLabelled = false;
  for (unsigned int block = 0; block < blocks->GetNumberOfBlocks(); ++block)
  {
    auto* mesh = vtkPolyData::SafeDownCast(blocks->GetBlock(block));
    isAnyLabelled = isAnyLabelled || mesh->GetCellData()->HasArray(name.c_str());
  }
  if (!isAnyLabelled)
  {
    vtkErrorMacro(
      << "Neither a step of the series nor a labelled mesh beside it has the cell array \"" << name
      << "\" of segments: connect a labelled mesh, or choose another array.");
    return false;
  }
  vtkCollectionTransfer* transfer = this->Steps->Transfer;
  transfer->SetCacheFolder(this->CacheFolder);
  transfer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name.c_str());
  transfer->SetAbortExecute(0);
  transfer->SetInputDataObject(blocks);
  transfer->Update();
  auto* result = vtkMultiBlockDataSet::SafeDownCast(transfer->GetOutputDataObject(0));
  for (std::size_t step = 0; step < this->Steps->Meshes.size(); ++step)
  {
    auto* mesh = vtkPolyData::SafeDownCast(result->GetBlock(static_cast<unsigned int>(step)));
    if (!mesh)
    {
      return false; // An error or an abort, of which is told.
    }
    this->Steps->Meshes[step] = mesh;
  }
  return true;
}

int vtkTimeSeriesTransfer::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (!this->Steps->IsComplete())
  {
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(vtkPolyData::GetData(inputVector[0]));
    this->Steps->Meshes.emplace_back(mesh);
    if (!this->Steps->IsComplete())
    {
      request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
      return 1;
    }
    request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
    const bool isIdle = std::all_of(this->Steps->Meshes.begin(), this->Steps->Meshes.end(),
      [&](vtkPolyData* of) { return marrow::IsIdleProcess(outputVector, of); });
    if (!isIdle && !this->Label(inputVector[1]))
    {
      this->Steps->Meshes.clear();
      return marrow::IsAborted(this) ? 1 : 0;
    }
  }
  const std::vector<double>& times = this->Steps->Times;
  std::size_t step = 0;
  if (info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    const auto nearest = std::min_element(times.begin(), times.end(),
      [time](double one, double other) { return std::abs(one - time) < std::abs(other - time); });
    step = static_cast<std::size_t>(nearest - times.begin());
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(this->Steps->Meshes[step]);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), times[step]);
  vtkTable::GetData(outputVector, 1)->ShallowCopy(this->Steps->Transfer->GetOutputDataObject(1));
  return 1;
}

void vtkTimeSeriesTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CacheFolder: " << (this->CacheFolder ? this->CacheFolder : "(none)") << "\n";
}
