// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSegmentationMetrics.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "InputCheck.h"
#include "LabelBridge.h"
#include "SegmentationScores.h"
#include "SurfaceBridge.h"
#include "SurfaceMending.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMarrowSegmentationMetrics);

namespace
{
/// Copies the selected segment array. Returns one sentence that says what is wrong, or an empty one.
std::string ToSegments(
  vtkDataArray* array, vtkPolyData* mesh, const std::string& role, std::vector<int>& segments)
{
  if (!array)
  {
    return "The " + role +
      " has no such cell array of segments; name one with SetInputArrayToProcess (default "
      "SegmentId).";
  }
  const std::string error = marrow::ToLabels(array, mesh->GetNumberOfCells(), "cell", segments);
  return error.empty() ? error : "The " + role + ": " + error;
}

/// The faces as they are, seams and twins mended so that boundaries do not end at them. What fills holes is
/// no face.
std::string ToFaces(
  vtkPolyData* input, marrow::TriangleMesh& mesh, std::vector<int>& faceOfTriangle)
{
  const marrow::SurfaceOfPolyData surface = marrow::ToPolygonMesh(input);
  const std::string error = marrow::CheckInput(surface.Mesh);
  if (!error.empty())
  {
    return error;
  }
  marrow::Mending mending;
  marrow::SurfaceReport report;
  marrow::MendSurface(surface.Mesh, mending, report);
  marrow::MendedMesh& mended = mending.Result;
  std::vector<char> isFace;
  for (int cell : mended.CellOfTriangle)
  {
    isFace.push_back(cell >= 0 ? 1 : 0);
  }
  mended.KeepTriangles(isFace);
  mesh = std::move(mended.Mesh);
  mesh.BuildConnectivity();
  for (int polygon : mended.CellOfTriangle)
  {
    faceOfTriangle.push_back(surface.CellOfPolygon[polygon]);
  }
  return {};
}
}

vtkMarrowSegmentationMetrics::vtkMarrowSegmentationMetrics()
{
  this->SetNumberOfInputPorts(2);
  for (int port = 0; port < 2; ++port)
  {
    this->SetInputArrayToProcess(
      port, port, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
  }
}

int vtkMarrowSegmentationMetrics::FillInputPortInformation(
  int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkMarrowSegmentationMetrics::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputVector[1]);
  vtkTable* output = vtkTable::GetData(outputVector);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }

  marrow::SegmentationScores scores;
  marrow::TriangleMesh mesh;
  std::vector<int> faceOfTriangle, segments, referenceSegments;
  std::string error = ToFaces(input, mesh, faceOfTriangle);
  if (error.empty() && input->GetNumberOfCells() != reference->GetNumberOfCells())
  {
    error = "The segmentation has " + std::to_string(input->GetNumberOfCells()) +
      " cells and the reference " + std::to_string(reference->GetNumberOfCells()) +
      "; compare two segmentations of the same mesh.";
  }
  if (error.empty())
  {
    error =
      ToSegments(this->GetInputArrayToProcess(0, inputVector), input, "segmentation", segments);
  }
  if (error.empty())
  {
    error = ToSegments(
      this->GetInputArrayToProcess(1, inputVector), reference, "reference", referenceSegments);
  }
  if (error.empty() && faceOfTriangle.empty())
  {
    error = "The mesh has no area; check its points.";
  }
  if (error.empty())
  {
    scores = marrow::CompareSegmentations(mesh, faceOfTriangle, segments, referenceSegments);
  }
  this->CutDiscrepancy = scores.CutDiscrepancy;
  this->HammingDistance = scores.HammingDistance;
  this->MissingRate = scores.MissingRate;
  this->FalseAlarmRate = scores.FalseAlarmRate;
  this->RandError = scores.RandError;
  this->GlobalConsistencyError = scores.GlobalConsistencyError;
  this->LocalConsistencyError = scores.LocalConsistencyError;
  this->LabelAccuracy = scores.LabelAccuracy;
  this->BoundaryDistance = scores.BoundaryDistance;
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  const auto addColumn = [output](const char* name, double value)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    column->InsertNextValue(value);
    output->AddColumn(column);
  };
  addColumn("CutDiscrepancy", this->CutDiscrepancy);
  addColumn("HammingDistance", this->HammingDistance);
  addColumn("MissingRate", this->MissingRate);
  addColumn("FalseAlarmRate", this->FalseAlarmRate);
  addColumn("RandError", this->RandError);
  addColumn("GlobalConsistencyError", this->GlobalConsistencyError);
  addColumn("LocalConsistencyError", this->LocalConsistencyError);
  addColumn("LabelAccuracy", this->LabelAccuracy);
  addColumn("BoundaryDistance", this->BoundaryDistance);
  return 1;
}

void vtkMarrowSegmentationMetrics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CutDiscrepancy: " << this->CutDiscrepancy << "\n";
  os << indent << "HammingDistance: " << this->HammingDistance << "\n";
  os << indent << "MissingRate: " << this->MissingRate << "\n";
  os << indent << "FalseAlarmRate: " << this->FalseAlarmRate << "\n";
  os << indent << "RandError: " << this->RandError << "\n";
  os << indent << "GlobalConsistencyError: " << this->GlobalConsistencyError << "\n";
  os << indent << "LocalConsistencyError: " << this->LocalConsistencyError << "\n";
  os << indent << "LabelAccuracy: " << this->LabelAccuracy << "\n";
  os << indent << "BoundaryDistance: " << this->BoundaryDistance << "\n";
}
