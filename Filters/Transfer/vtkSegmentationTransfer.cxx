// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentationTransfer.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "FullResolution.h"
#include "MatchedSkeletons.h"
#include "MeshBridge.h"
#include "SegmentLoops.h"
#include "SegmentationTransfer.h"
#include "TransferInputs.h"
#include "WorkingBodies.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
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
  std::vector<unsigned char> strict;
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
    strict.push_back(pair.IsStrict ? 1 : 0);
  }
  output->Initialize();
  output->SetPoints(points);
  output->SetLines(lines);
  marrow::SetIdArray(output->GetCellData(), marrow::names::BoundaryId, ids);
  marrow::SetIntArray(output->GetCellData(), "FirstSegmentId", first);
  marrow::SetIntArray(output->GetCellData(), "SecondSegmentId", second);
  marrow::SetArray(output->GetCellData(), "EnclosesBranch", strict);
}

/// What an inner filter complains of, as if the outer one did.
struct ForwardMessages : vtkCommand
{
  static ForwardMessages* New() { return new ForwardMessages; }
  void Execute(vtkObject*, unsigned long event, void* text) override
  {
    if (this->Outer->HasObserver(event))
    {
      this->Outer->InvokeEvent(event, text);
    }
    else if (event == vtkCommand::ErrorEvent)
    {
      vtkOutputWindowDisplayErrorText(static_cast<const char*>(text));
    }
    else
    {
      vtkOutputWindowDisplayWarningText(static_cast<const char*>(text));
    }
  }
  vtkObject* Outer = nullptr;
};

void WriteLabels(vtkPolyData* target, const std::vector<int>& labels,
  const std::vector<double>& confidence, vtkPolyData* output)
{
  output->ShallowCopy(target);
  marrow::SetIntArray(output->GetCellData(), marrow::names::SegmentId, labels);
  output->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  marrow::SetArray(output->GetCellData(), marrow::names::SegmentConfidence, confidence);
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
  if (!vtkPolyData::GetData(inputVector[2]) && !vtkPolyData::GetData(inputVector[3]))
  {
    const int done = this->TransferBodies(inputVector, outputVector);
    if (done >= 0)
    {
      return done;
    }
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
  marrow::CorrespondenceIds ids;
  double confidence = 1.0;
  error = error.empty() ? marrow::CompleteSide(this, 0.0, 0.35, source, sourceMesh) : error;
  error = error.empty() && !marrow::IsAborted(this)
    ? marrow::CompleteSide(this, 0.35, 0.7, target, targetMesh)
    : error;
  error = error.empty() && !marrow::IsAborted(this)
    ? marrow::ReadCorrespondence(this, 0.7, 0.75, source, target, ids, confidence)
    : error;
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

  const marrow::MatchedSkeletons match =
    marrow::JoinChains(sourceMesh.Skeleton, targetMesh.Skeleton, ids);
  confidence = match.IsEmpty() ? std::min(confidence, 0.2) : confidence;
  marrow::TransferParameters parameters;
  parameters.Theta = this->Theta;
  parameters.Kernel = this->Kernel;
  parameters.Lambda = this->Lambda;
  parameters.SearchRegion = this->SearchRegion;
  parameters.StrictBoundaries = this->StrictBoundaries;
  const marrow::TransferResult result = marrow::TransferSegmentation(sourceMesh, targetMesh, match,
    confidence, labels, parameters, marrow::ProgressOf(this, 0.75, 1.0));
  if (result.IsAborted)
  {
    return 1;
  }
  if (result.IsWholeAlignment)
  {
    vtkWarningMacro(<< (match.IsEmpty() ? "No branch of the skeletons is matched"
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

  WriteLabels(inputTarget, result.Labels, result.Confidence, vtkPolyData::GetData(outputVector, 0));
  WriteBoundaries(result.Boundaries, true, vtkPolyData::GetData(outputVector, 1));
  WriteBoundaries(result.Boundaries, false, vtkPolyData::GetData(outputVector, 2));
  return 1;
}

int vtkSegmentationTransfer::TransferBodies(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* inputs[2] = { vtkPolyData::GetData(inputVector[0]),
    vtkPolyData::GetData(inputVector[1]) };
  marrow::WorkingBodies bodies[2];
  for (int side = 0; side < 2; ++side)
  {
    // A small part of the time, and where nothing is to mend the progress begins after it.
    const std::string error =
      marrow::MakeWorkingBodies(inputs[side], bodies[side], marrow::ProgressOf(this, 0.0, 0.0));
    if (!error.empty())
    {
      vtkErrorMacro(<< (side == 0 ? "Source: " : "Target: ") << error);
      return 0;
    }
    if (marrow::IsAborted(this))
    {
      return 1;
    }
  }
  if (bodies[0].Meshes.front() == inputs[0] && bodies[1].Meshes.front() == inputs[1])
  {
    return -1;
  }

  std::vector<int> labels;
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  const std::string error = marrow::ReadLabels(inputs[0],
    this->GetInputArrayToProcess(0, inputVector), name ? name : marrow::names::SegmentId, labels);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  std::vector<vtkSmartPointer<vtkPolyData>> sources;
  const std::vector<std::vector<int>> ofBodies = marrow::LabelsOfBodies(bodies[0], labels);
  for (std::size_t b = 0; b < ofBodies.size(); ++b)
  {
    sources.push_back(CopyOf(bodies[0].Meshes[b]));
    marrow::SetIntArray(sources.back()->GetCellData(), marrow::names::SegmentId, ofBodies[b]);
  }

  const marrow::WorkingSurface& surface = bodies[1].Surface;
  std::vector<int> ofTriangles(surface.Mesh.Triangles.size(), 0);
  std::vector<double> confidence(surface.Mesh.Triangles.size(), 0.0);
  vtkNew<vtkAppendPolyData> boundaries[2];
  const double step = 1.0 / static_cast<double>(bodies[1].Meshes.size() * sources.size());
  double begin = 0.0;
  for (std::size_t b = 0; b < bodies[1].Meshes.size(); ++b)
  {
    // A body takes its segments from the source's body that is most sure of them.
    vtkSmartPointer<vtkSegmentationTransfer> best;
    double most = -1.0;
    for (vtkPolyData* source : sources)
    {
      auto inner = vtkSmartPointer<vtkSegmentationTransfer>::New();
      inner->StrictBoundaries = this->StrictBoundaries;
      inner->Theta = this->Theta;
      inner->Kernel = this->Kernel;
      inner->Lambda = this->Lambda;
      inner->SearchRegion = this->SearchRegion;
      inner->SetInputData(0, source);
      inner->SetInputData(1, bodies[1].Meshes[b]);
      vtkNew<ForwardMessages> messages;
      messages->Outer = this;
      inner->AddObserver(vtkCommand::ErrorEvent, messages);
      inner->AddObserver(vtkCommand::WarningEvent, messages);
      marrow::WatchInner(this, inner, begin, begin + step);
      begin += step;
      inner->Update();
      if (marrow::IsAborted(this))
      {
        return 1;
      }
      vtkDataArray* sure =
        inner->GetOutput()->GetCellData()->GetArray(marrow::names::SegmentConfidence);
      double sum = 0.0;
      for (vtkIdType c = 0; sure && c < sure->GetNumberOfTuples(); ++c)
      {
        sum += sure->GetTuple1(c);
      }
      if (sure && sum > most)
      {
        most = sum;
        best = inner;
      }
    }
    if (!best)
    {
      vtkErrorMacro("The segments could not be transferred: see the message before.");
      return 0;
    }
    vtkCellData* cells = best->GetOutput()->GetCellData();
    for (std::size_t t = 0; t < bodies[1].TrianglesOfBody[b].size(); ++t)
    {
      const vtkIdType cell = static_cast<vtkIdType>(t);
      const int triangle = bodies[1].TrianglesOfBody[b][t];
      ofTriangles[triangle] =
        static_cast<int>(cells->GetArray(marrow::names::SegmentId)->GetTuple1(cell));
      confidence[triangle] = cells->GetArray(marrow::names::SegmentConfidence)->GetTuple1(cell);
    }
    for (int side = 0; side < 2; ++side)
    {
      boundaries[side]->AddInputData(
        CopyOf(vtkPolyData::SafeDownCast(best->GetOutputDataObject(1 + side))));
    }
  }

  const std::vector<int> ofPolygons =
    marrow::LabelsOfPolygons(surface, marrow::LabelsAtFullResolution(surface, ofTriangles));
  // Vertices and lines among the cells are no surface and have no segment.
  std::vector<int> ofCells(bodies[1].NumberOfCells, -1);
  std::vector<double> confidenceOfCells(bodies[1].NumberOfCells, 0.0);
  for (std::size_t p = 0; p < ofPolygons.size(); ++p)
  {
    const int cell = bodies[1].CellOfPolygon[p];
    ofCells[cell] = ofPolygons[p];
    confidenceOfCells[cell] = confidence[surface.TriangleOfCell(static_cast<int>(p))];
  }
  WriteLabels(inputs[1], ofCells, confidenceOfCells, vtkPolyData::GetData(outputVector, 0));
  for (int side = 0; side < 2; ++side)
  {
    boundaries[side]->Update();
    vtkPolyData::GetData(outputVector, 1 + side)->ShallowCopy(boundaries[side]->GetOutput());
  }
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
