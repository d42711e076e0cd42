// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSegmentCutter.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "InputCheck.h"
#include "LabelBridge.h"
#include "MeshBridge.h"
#include "SegmentCut.h"
#include "SurfaceBridge.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkMarrowSegmentCutter);

namespace
{
/// The points of the input and those that the cut adds, with their arrays.
void WritePoints(vtkPolyData* input, const marrow::SegmentCut& cut, vtkPolyData* output)
{
  const vtkIdType given = input->GetNumberOfPoints();
  const auto added = static_cast<vtkIdType>(cut.NewPoints.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(given + added);
  vtkPointData* data = output->GetPointData();
  data->InterpolateAllocate(input->GetPointData(), given + added);
  for (vtkIdType i = 0; i < given; ++i)
  {
    points->SetPoint(i, input->GetPoint(i));
    data->CopyData(input->GetPointData(), i, i);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < added; ++i)
  {
    const marrow::SegmentCut::NewPoint& made = cut.NewPoints[i];
    double position[3] = { 0.0, 0.0, 0.0 };
    double weights[3] = { 0.0, 0.0, 0.0 };
    ids->SetNumberOfIds(made.Size);
    for (int k = 0; k < made.Size; ++k)
    {
      ids->SetId(k, made.Points[k]);
      weights[k] = made.Weights[k];
      double corner[3];
      input->GetPoint(made.Points[k], corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis] += made.Weights[k] * corner[axis];
      }
    }
    points->SetPoint(given + i, position);
    data->InterpolatePoint(input->GetPointData(), given + i, ids, weights);
  }
  output->SetPoints(points);
}

void WritePieces(vtkPolyData* input, const std::vector<int>& cellOfPolygon,
  const marrow::SegmentCut& cut, vtkPolyData* output)
{
  const std::size_t size = cut.PolygonOfPiece.size();
  vtkNew<vtkCellArray> pieces;
  pieces->AllocateExact(static_cast<vtkIdType>(size), static_cast<vtkIdType>(cut.Corners.size()));
  vtkCellData* data = output->GetCellData();
  data->CopyAllocate(input->GetCellData(), static_cast<vtkIdType>(size));
  std::vector<int> originals;
  originals.reserve(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    pieces->InsertNextCell(cut.Offsets[i + 1] - cut.Offsets[i]);
    for (int k = cut.Offsets[i]; k < cut.Offsets[i + 1]; ++k)
    {
      pieces->InsertCellPoint(cut.Corners[k]);
    }
    originals.push_back(cellOfPolygon[cut.PolygonOfPiece[i]]);
    data->CopyData(input->GetCellData(), originals.back(), static_cast<vtkIdType>(i));
  }
  output->SetPolys(pieces);
  marrow::SetIdArray(data, marrow::names::OriginalCellIds, originals);
  marrow::SetIntArray(data, marrow::names::SegmentId, cut.LabelOfPiece);
  data->SetActiveScalars(marrow::names::SegmentId);
}
}

vtkMarrowSegmentCutter::vtkMarrowSegmentCutter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

int vtkMarrowSegmentCutter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }
  std::vector<int> labels;
  std::string error = marrow::ReadLabels(
    input, this->GetInputArrayToProcess(0, inputVector), marrow::NameOfSegments(this), labels);
  const marrow::SurfaceOfPolyData faces = marrow::ToPolygonMesh(input);
  if (error.empty())
  {
    error = marrow::CheckInput(faces.Mesh);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  std::vector<int> labelOfPolygon;
  labelOfPolygon.reserve(faces.CellOfPolygon.size());
  for (const int cell : faces.CellOfPolygon)
  {
    labelOfPolygon.push_back(labels[cell]);
  }
  const marrow::SegmentCut cut =
    marrow::CutAlongSegments(faces.Mesh, labelOfPolygon, marrow::ProgressOf(this));
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  WritePoints(input, cut, output);
  WritePieces(input, faces.CellOfPolygon, cut, output);
  output->GetFieldData()->PassData(input->GetFieldData());
  return 1;
}
