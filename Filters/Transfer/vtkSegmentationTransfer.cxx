// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentationTransfer.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MatchedSkeletons.h"
#include "MeshBridge.h"
#include "SegmentLoops.h"
#include "SegmentationTransfer.h"
#include "TransferInputs.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSegmentationTransfer);

namespace
{
vtkSmartPointer<vtkPolyData> CopyOf(vtkPolyData* data)
{
  if (!data)
  {
    return nullptr;
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(data);
  return copy;
}

/// One closed polyline for every boundary that has points on this side.
void WriteBoundaries(
  const std::vector<marrow::BoundaryPair>& boundaries, bool source, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::vector<int> ids;
  std::vector<int> first;
  std::vector<int> second;
  std::vector<unsigned char> enclosesBranch;
  for (std::size_t b = 0; b < boundaries.size(); ++b)
  {
    const marrow::BoundaryPair& pair = boundaries[b];
    const auto& line = source ? pair.SourcePoints : pair.TargetPoints;
    if (line.empty())
    {
      continue;
    }
    const vtkIdType start = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(line.size()) + 1);
    for (const auto& point : line)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
    lines->InsertCellPoint(start);
    ids.push_back(static_cast<int>(b));
    first.push_back(pair.LeftLabel);
    second.push_back(pair.RightLabel);
    enclosesBranch.push_back(pair.EnclosesBranch ? 1 : 0);
  }
  output->Initialize();
  output->SetPoints(points);
  output->SetLines(lines);
  marrow::SetIdArray(output->GetCellData(), marrow::names::BoundaryId, ids);
  marrow::SetIntArray(output->GetCellData(), "FirstSegmentId", first);
  marrow::SetIntArray(output->GetCellData(), "SecondSegmentId", second);
  marrow::SetArray(output->GetCellData(), "EnclosesBranch", enclosesBranch);
}

std::string Join(const std::vector<int>& values)
{
  std::string text;
  for (int value : values)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(value);
  }
  return text;
}
}

vtkSegmentationTransfer::vtkSegmentationTransfer()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

int vtkSegmentationTransfer::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port >= 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSegmentationTransfer::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* inputTarget = vtkPolyData::GetData(inputVector[1]);
  if (marrow::IsIdleProcess(outputVector, inputTarget))
  {
    return 1;
  }
  marrow::TransferSide source{ "Source", CopyOf(vtkPolyData::GetData(inputVector[0])),
    CopyOf(vtkPolyData::GetData(inputVector[2])) };
  marrow::TransferSide target{ "Target", CopyOf(inputTarget),
    CopyOf(vtkPolyData::GetData(inputVector[3])) };

  std::vector<int> labels;
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  std::string error = marrow::ReadLabels(source.Mesh, this->GetInputArrayToProcess(0, inputVector),
    name ? name : marrow::names::SegmentId, labels);
  marrow::AnalyzedMesh sourceMesh;
  marrow::AnalyzedMesh targetMesh;
  std::vector<marrow::Answer> answers;
  error = error.empty() ? marrow::CompleteSide(this, 0.0, 0.35, source, sourceMesh) : error;
  error = error.empty() && !marrow::IsAborted(this)
    ? marrow::CompleteSide(this, 0.35, 0.7, target, targetMesh)
    : error;
  if (error.empty() && !marrow::IsAborted(this))
  {
    answers = marrow::FindAnswers(this, 0.7, 0.75, source, sourceMesh, target, targetMesh);
  }
  if (error.empty() && !labels.empty())
  {
    const int numberOfPieces = marrow::FindPieces(sourceMesh.Mesh, labels).NumberOfPieces();
    if (numberOfPieces > marrow::MostPieces)
    {
      error = "Source: the segments fall into " + std::to_string(numberOfPieces) +
        " connected pieces, more than " + std::to_string(marrow::MostPieces) +
        ": merge the small ones with their neighbours first.";
    }
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (marrow::IsAborted(this))
  {
    return 1;
  }

  marrow::TransferParameters parameters;
  parameters.Theta = this->Theta;
  parameters.Kernel = this->Kernel;
  parameters.Lambda = this->Lambda;
  parameters.SearchRegion = this->SearchRegion;
  parameters.StrictBoundaries = this->StrictBoundaries;
  const marrow::TransferResult result = marrow::TransferSegmentation(
    sourceMesh, targetMesh, answers, labels, parameters, marrow::ProgressOf(this, 0.75, 1.0));
  if (result.IsAborted)
  {
    return 1;
  }
  if (result.IsWholeAlignment)
  {
    vtkWarningMacro(<< (answers[result.Answer].Match.IsEmpty()
                           ? "No branch of the skeletons is matched"
                           : "The matched skeletons bring the surfaces together no "
                             "better than their principal axes")
                    << ": the meshes are aligned as wholes, and the segments are only as good as "
                       "that.");
  }
  if (result.NumberOfMissingPieces > 0)
  {
    vtkWarningMacro(<< result.NumberOfMissingPieces
                    << " connected pieces of the source's segments have no place on the target"
                    << (result.MissingLabels.empty() ? std::string()
                                                     : "; segments that are missing altogether: " +
                             Join(result.MissingLabels))
                    << ".");
  }

  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(inputTarget);
  marrow::SetIntArray(output->GetCellData(), marrow::names::SegmentId, result.Labels);
  output->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  marrow::SetArray(output->GetCellData(), marrow::names::SegmentConfidence, result.Confidence);
  WriteBoundaries(result.Boundaries, true, vtkPolyData::GetData(outputVector, 1));
  WriteBoundaries(result.Boundaries, false, vtkPolyData::GetData(outputVector, 2));
  return 1;
}

void vtkSegmentationTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StrictBoundaries: " << (this->StrictBoundaries ? "On" : "Off") << "\n";
  os << indent << "Theta: " << this->Theta << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "Lambda: " << this->Lambda << "\n";
  os << indent << "SearchRegion: " << this->SearchRegion << "\n";
}
