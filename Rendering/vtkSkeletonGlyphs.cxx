// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkeletonGlyphs.h"

#include "ArrayNames.h"
#include "Skeleton.h"
#include "vtkLabelColors.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkSkeletonGlyphs);

namespace
{
constexpr double TerminalColor[3] = { 0.0, 0.447, 0.698 };
constexpr double JunctionColor[3] = { 0.835, 0.369, 0.0 };
constexpr double BranchColor[3] = { 0.25, 0.25, 0.25 };

void AddColors(
  vtkPolyData* part, vtkIdType count, const double rgb[3], vtkUnsignedCharArray* colors)
{
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    colors->InsertNextTuple3(255 * rgb[0], 255 * rgb[1], 255 * rgb[2]);
  }
  part->GetCellData()->SetScalars(colors);
}

void ColorOfId(vtkDataArray* ids, vtkIdType index, double rgb[3])
{
  vtkLabelColors::GetColor(ids ? static_cast<vtkIdType>(ids->GetTuple1(index)) : -1, rgb);
}

/// One tube, apart from the others: they share points, and each has a colour of its own.
void AppendTube(vtkPolyData* skeleton, vtkIdType cell, double radius, const double rgb[3],
  vtkAppendPolyData* append)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  skeleton->GetCellPoints(cell, size, ids);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(size, ids);
  vtkNew<vtkPolyData> branch;
  branch->SetPoints(skeleton->GetPoints());
  branch->SetLines(line);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(branch);
  tube->SetRadius(radius);
  tube->SetNumberOfSides(12);
  tube->CappingOn();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(tube->GetOutputPort());
  triangles->Update();
  vtkNew<vtkUnsignedCharArray> colors;
  AddColors(triangles->GetOutput(), triangles->GetOutput()->GetNumberOfCells(), rgb, colors);
  append->AddInputData(triangles->GetOutput());
}

void AppendBall(
  const double center[3], double radius, const double rgb[3], vtkAppendPolyData* append)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(16);
  sphere->Update();
  vtkNew<vtkUnsignedCharArray> colors;
  AddColors(sphere->GetOutput(), sphere->GetOutput()->GetNumberOfCells(), rgb, colors);
  append->AddInputData(sphere->GetOutput());
}
}

int vtkSkeletonGlyphs::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkNew<vtkPolyData> skeleton;
  skeleton->ShallowCopy(input);
  skeleton->BuildCells();

  vtkDataArray* meshDiagonal = skeleton->GetFieldData()->GetArray(marrow::names::MeshDiagonal);
  const double diagonal = meshDiagonal && meshDiagonal->GetNumberOfTuples() > 0
    ? meshDiagonal->GetTuple1(0)
    : skeleton->GetLength();
  vtkDataArray* types = skeleton->GetPointData()->GetArray(marrow::names::NodeType);
  vtkDataArray* nodeIds = skeleton->GetPointData()->GetArray(marrow::names::CorrespondenceId);
  vtkDataArray* branchIds =
    skeleton->GetCellData()->GetArray(marrow::names::BranchCorrespondenceId);
  const bool byId = this->ColorBy == CORRESPONDENCE;

  vtkNew<vtkAppendPolyData> append;
  for (vtkIdType cell = 0; cell < skeleton->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    skeleton->GetCellPoints(cell, size, ids);
    if (size < 2)
    {
      continue;
    }
    double rgb[3] = { BranchColor[0], BranchColor[1], BranchColor[2] };
    if (byId)
    {
      ColorOfId(branchIds, cell, rgb);
    }
    AppendTube(skeleton, cell, this->TubeRadius * diagonal, rgb, append);
  }
  for (vtkIdType node = 0; types && node < skeleton->GetNumberOfPoints(); ++node)
  {
    const auto type = static_cast<marrow::NodeType>(static_cast<int>(types->GetTuple1(node)));
    if (type == marrow::NodeType::Regular)
    {
      continue;
    }
    const double* fixed = type == marrow::NodeType::Junction ? JunctionColor : TerminalColor;
    double rgb[3] = { fixed[0], fixed[1], fixed[2] };
    if (byId)
    {
      ColorOfId(nodeIds, node, rgb);
    }
    AppendBall(skeleton->GetPoint(node), this->BallRadius * diagonal, rgb, append);
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    output->ShallowCopy(append->GetOutput());
    output->GetCellData()->SetActiveScalars("Color");
  }
  return 1;
}

void vtkSkeletonGlyphs::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColorBy: " << (this->ColorBy == NODE_TYPE ? "NodeType" : "Correspondence")
     << "\n";
  os << indent << "TubeRadius: " << this->TubeRadius << "\n";
  os << indent << "BallRadius: " << this->BallRadius << "\n";
}
