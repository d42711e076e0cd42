// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentationTransfer.h"

#include "AnalyzedSide.h"
#include "ArrayNames.h"
#include "FilterSupport.h"
#include "HintBridge.h"
#include "LabelBridge.h"
#include "MeshBridge.h"
#include "ParallelFor.h"
#include "SegmentLoops.h"
#include "SharedProgress.h"
#include "SideTransfer.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSegmentationTransfer);

namespace
{
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

std::string Join(const std::set<int>& values)
{
  std::string text;
  for (int value : values)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(value);
  }
  return text;
}
}

/// What is known of the two meshes, kept as long as they are the same: a parameter of the transfer changes
/// nothing about them, and one source may serve many targets.
struct vtkSegmentationTransfer::Analysis
{
  marrow::AnalyzedSide Sides[2];

  /// Both at a time, as neither needs the other. The error names its side.
  std::string Update(
    vtkPolyData* const meshes[2], vtkPolyData* const skeletons[2], const marrow::Progress& progress)
  {
    constexpr const char* names[2] = { "Source: ", "Target: " };
    std::string errors[2];
    marrow::SharedProgress shared(progress);
    marrow::ParallelFor(0, 2,
      [&](int first, int last)
      {
        for (int side = first; side < last; ++side)
        {
          errors[side] = this->UpdateSide(side, meshes[side], skeletons[side], shared);
        }
      });
    for (int side = 0; side < 2; ++side)
    {
      if (!errors[side].empty())
      {
        return names[side] + errors[side];
      }
    }
    return {};
  }

private:
  std::string UpdateSide(
    int side, vtkPolyData* mesh, vtkPolyData* skeleton, marrow::SharedProgress& progress)
  {
    const Key key = { mesh, mesh->GetMTime(), skeleton, skeleton ? skeleton->GetMTime() : 0 };
    if (this->Keys[side] == key)
    {
      progress.Add(0.5);
      return {};
    }
    bool isStopped = false;
    double done = 0.0;
    this->Keys[side] = {};
    this->Sides[side] = {};
    const std::string error = marrow::AnalyzeSide(mesh, skeleton, this->Sides[side],
      [&](double fraction)
      {
        isStopped = isStopped || !progress.Add(0.5 * (fraction - done));
        done = fraction;
        return !isStopped;
      });
    if (error.empty() && !isStopped)
    {
      this->Keys[side] = key;
    }
    return error;
  }

  using Key = std::tuple<vtkPolyData*, vtkMTimeType, vtkPolyData*, vtkMTimeType>;
  Key Keys[2];
};

vtkSegmentationTransfer::vtkSegmentationTransfer()
  : Analyzed(new Analysis)
{
  this->SetNumberOfInputPorts(6);
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

vtkSegmentationTransfer::~vtkSegmentationTransfer() = default;

int vtkSegmentationTransfer::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port < 4 ? "vtkPolyData" : "vtkPointSet");
  if (port >= 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSegmentationTransfer::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* sourceMesh = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* targetMesh = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* sourceSkeleton = vtkPolyData::GetData(inputVector[2]);
  vtkPolyData* targetSkeleton = vtkPolyData::GetData(inputVector[3]);
  if (marrow::IsIdleProcess(outputVector, targetMesh))
  {
    return 1;
  }
  const auto fail = [this](const std::string& error)
  {
    vtkErrorMacro(<< error);
    return 0;
  };

  std::vector<int> labels;
  marrow::SideGuidance guidance;
  guidance.AnswerIndex = this->AnswerIndex;
  const auto readLabels = [](const char* side, vtkPolyData* mesh, vtkDataArray* array,
                            const std::string& name, std::vector<int>& ofCells)
  {
    const std::string error = marrow::ReadLabels(mesh, array, name, ofCells);
    return error.empty() ? error : side + (": " + error);
  };
  std::string error = readLabels("Source", sourceMesh, this->GetInputArrayToProcess(0, inputVector),
    marrow::NameOfSegments(this), labels);
  if (error.empty() && this->KeepTargetSegments)
  {
    vtkDataArray* own = targetMesh->GetCellData()->GetArray(marrow::names::SegmentId);
    error = readLabels("Target", targetMesh, own, marrow::names::SegmentId, guidance.KeptLabels);
  }
  if (error.empty())
  {
    error = marrow::ReadHints(
      vtkPointSet::GetData(inputVector[4]), vtkPointSet::GetData(inputVector[5]), guidance.Hints);
  }
  if (!error.empty())
  {
    return fail(error);
  }
  marrow::AnalyzedSide& source = this->Analyzed->Sides[0];
  marrow::AnalyzedSide& target = this->Analyzed->Sides[1];
  vtkPolyData* const meshes[2] = { sourceMesh, targetMesh };
  vtkPolyData* const skeletons[2] = { sourceSkeleton, targetSkeleton };
  error = this->Analyzed->Update(meshes, skeletons, marrow::ProgressOf(this, 0.0, 0.7));
  if (!error.empty())
  {
    return fail(error);
  }
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  std::vector<std::vector<int>> labelsOfBodies;
  int numberOfPieces = 0;
  for (const marrow::Body& body : source.Surface.Bodies)
  {
    labelsOfBodies.push_back(marrow::LabelsOfBody(source.Surface, body, labels));
    numberOfPieces += marrow::FindPieces(body.Mesh, labelsOfBodies.back()).NumberOfPieces();
  }
  if (numberOfPieces > marrow::MostPieces)
  {
    return fail("Source: the segments fall into " + std::to_string(numberOfPieces) +
      " connected pieces, more than " + std::to_string(marrow::MostPieces) +
      ": merge the small ones with their neighbours first.");
  }

  marrow::TransferParameters parameters;
  parameters.Theta = this->Theta;
  parameters.Kernel = this->Kernel;
  parameters.Lambda = this->Lambda;
  parameters.SearchRegion = this->SearchRegion;
  parameters.StrictBoundaries = this->StrictBoundaries;
  marrow::SideTransferResult result = marrow::TransferSide(source, target,
    marrow::ReadCorrespondence(sourceSkeleton), marrow::ReadCorrespondence(targetSkeleton),
    labelsOfBodies, parameters, guidance, marrow::ProgressOf(this, 0.7, 1.0));
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  if (!result.Error.empty())
  {
    return fail(result.Error);
  }
  this->DropWhatIsNotCarried(guidance.KeptLabels, result);
  if (result.IsWholeAlignment)
  {
    vtkWarningMacro(<< (result.IsMatched ? "The surfaces fit better as wholes than by the "
                                           "matched skeletons"
                                         : "No branch of the skeletons is matched")
                    << ": the meshes are aligned as wholes, and the segments are only as good as "
                       "that.");
  }
  if (result.NumberOfUnmetHints > 0)
  {
    vtkWarningMacro(<< "No answer keeps to all hints: " << result.NumberOfUnmetHints << " of "
                    << guidance.Hints.size()
                    << " are contradicted. Do they contradict each other?");
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
  output->ShallowCopy(targetMesh);
  marrow::SetIntArray(output->GetCellData(), marrow::names::SegmentId, result.Labels);
  output->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  marrow::SetArray(output->GetCellData(), marrow::names::SegmentConfidence, result.Confidence);
  for (const auto& [arrayName, value] : { std::pair{ marrow::names::MatchingCost, result.Cost },
         std::pair{ marrow::names::MatchingEvidence, result.Evidence },
         std::pair{ marrow::names::MatchingConfidence, result.AnswerConfidence } })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(arrayName);
    array->InsertNextValue(value);
    output->GetFieldData()->AddArray(array);
  }
  vtkNew<vtkStringArray> matchedBy;
  matchedBy->SetName(marrow::names::MatchedBy);
  for (const std::string& way : result.MatchedBy)
  {
    matchedBy->InsertNextValue(way);
  }
  output->GetFieldData()->AddArray(matchedBy);
  output->GetFieldData()->RemoveArray(marrow::names::SegmentName);
  if (vtkAbstractArray* segmentNames =
        sourceMesh->GetFieldData()->GetAbstractArray(marrow::names::SegmentName))
  {
    output->GetFieldData()->AddArray(segmentNames);
  }
  marrow::WriteNote(target.Surface, output);
  WriteBoundaries(result.Boundaries, true, vtkPolyData::GetData(outputVector, 1));
  marrow::WriteNote(source.Surface, vtkPolyData::GetData(outputVector, 1));
  WriteBoundaries(result.Boundaries, false, vtkPolyData::GetData(outputVector, 2));
  return 1;
}

void vtkSegmentationTransfer::AddCarriedSegment(int segment)
{
  if (this->CarriedSegments.insert(segment).second)
  {
    this->Modified();
  }
}

void vtkSegmentationTransfer::RemoveAllCarriedSegments()
{
  if (!this->CarriedSegments.empty())
  {
    this->CarriedSegments.clear();
    this->Modified();
  }
}

void vtkSegmentationTransfer::DropWhatIsNotCarried(
  const std::vector<int>& keptLabels, marrow::SideTransferResult& result) const
{
  if (this->CarriedSegments.empty())
  {
    return;
  }
  const auto isCarried = [this](int segment) { return this->CarriedSegments.count(segment) > 0; };
  for (std::size_t cell = 0; cell < result.Labels.size(); ++cell)
  {
    const bool isKept = !keptLabels.empty() && keptLabels[cell] != marrow::NoLabel;
    if (!isKept && !isCarried(result.Labels[cell]))
    {
      result.Labels[cell] = marrow::NoLabel;
      result.Confidence[cell] = 0.0;
    }
  }
}

void vtkSegmentationTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AnswerIndex: " << this->AnswerIndex << "\n";
  os << indent << "KeepTargetSegments: " << (this->KeepTargetSegments ? "On" : "Off") << "\n";
  os << indent
     << "CarriedSegments: " << (this->CarriedSegments.empty() ? "all" : Join(this->CarriedSegments))
     << "\n";
  os << indent << "StrictBoundaries: " << (this->StrictBoundaries ? "On" : "Off") << "\n";
  os << indent << "Theta: " << this->Theta << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "Lambda: " << this->Lambda << "\n";
  os << indent << "SearchRegion: " << this->SearchRegion << "\n";
}
