// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSkeletonGlyphs.h"

#include "ArrayNames.h"
#include "Skeleton.h"
#include "vtkMarrowLabelColors.h"

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

vtkStandardNewMacro(vtkMarrowSkeletonGlyphs);

namespace
{
constexpr double TerminalColor[3] = { 0.0, 0.447, 0.698 };
constexpr double JunctionColor[3] = { 0.835, 0.369, 0.0 };
constexpr double BranchColor[3] = { 0.25, 0.25, 0.25 };
/// Radius of a regular node's ball over that of a feature node.
constexpr double RegularBall = 0.7;

/// The arrays that the colours come from; null where they do not.
struct ColorArrays
{
  vtkDataArray* OfNodes = nullptr;
  vtkDataArray* OfBranches = nullptr;
  bool NodesAlongBranches = false; ///< the tubes too have the nodes' colours
};

ColorArrays FindColorArrays(vtkPolyData* skeleton, int colorBy, const char* labelArray)
{
  ColorArrays arrays;
  vtkPointData* points = skeleton->GetPointData();
  vtkCellData* cells = skeleton->GetCellData();
  switch (colorBy)
  {
    case vtkMarrowSkeletonGlyphs::CORRESPONDENCE:
      arrays.OfNodes = points->GetArray(marrow::names::CorrespondenceId);
      arrays.OfBranches = cells->GetArray(marrow::names::BranchCorrespondenceId);
      break;
    case vtkMarrowSkeletonGlyphs::BRANCH:
      arrays.OfBranches = cells->GetArray(marrow::names::BranchId);
      break;
    case vtkMarrowSkeletonGlyphs::LABEL:
      arrays.OfNodes = points->GetArray(labelArray);
      arrays.NodesAlongBranches = arrays.OfNodes != nullptr;
      break;
    default:
      break;
  }
  return arrays;
}

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
  vtkMarrowLabelColors::GetColor(static_cast<vtkIdType>(ids->GetTuple1(index)), rgb);
}

/// One tube, apart from the others: they share points, and each has a colour of its own.
void AppendTube(vtkPolyData* skeleton, vtkIdType size, const vtkIdType* ids, double radius,
  const double rgb[3], vtkAppendPolyData* append)
{
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

/// A branch, in pieces of one colour each: a piece ends where the next one begins.
void AppendBranch(vtkPolyData* skeleton, vtkIdType cell, const ColorArrays& arrays, double radius,
  vtkAppendPolyData* append)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  skeleton->GetCellPoints(cell, size, ids);
  double rgb[3] = { BranchColor[0], BranchColor[1], BranchColor[2] };
  if (arrays.OfBranches)
  {
    ColorOfId(arrays.OfBranches, cell, rgb);
  }
  for (vtkIdType first = 0, last = 1; last < size; ++last)
  {
    if (last + 1 < size &&
      (!arrays.NodesAlongBranches ||
        arrays.OfNodes->GetTuple1(ids[last]) == arrays.OfNodes->GetTuple1(ids[first])))
    {
      continue;
    }
    if (arrays.NodesAlongBranches)
    {
      ColorOfId(arrays.OfNodes, ids[first], rgb);
    }
    AppendTube(skeleton, last - first + 1, ids + first, radius, rgb, append);
    first = last;
  }
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

vtkMarrowSkeletonGlyphs::vtkMarrowSkeletonGlyphs()
{
  this->SetLabelArrayName(marrow::names::SegmentId);
}

vtkMarrowSkeletonGlyphs::~vtkMarrowSkeletonGlyphs()
{
  this->SetLabelArrayName(nullptr);
}

int vtkMarrowSkeletonGlyphs::RequestData(
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
  const ColorArrays arrays = FindColorArrays(skeleton, this->ColorBy, this->LabelArrayName);

  vtkNew<vtkAppendPolyData> append;
  for (vtkIdType cell = 0; cell < skeleton->GetNumberOfCells(); ++cell)
  {
    AppendBranch(skeleton, cell, arrays, this->TubeRadius * diagonal, append);
  }
  for (vtkIdType node = 0; types && node < skeleton->GetNumberOfPoints(); ++node)
  {
    const auto type = static_cast<marrow::NodeType>(static_cast<int>(types->GetTuple1(node)));
    const bool isRegular = type == marrow::NodeType::Regular;
    if (isRegular && !this->ShowRegularNodes)
    {
      continue;
    }
    const bool hasTypeColor = !isRegular && !arrays.OfBranches;
    const double* fixed = !hasTypeColor    ? BranchColor
      : type == marrow::NodeType::Junction ? JunctionColor
                                           : TerminalColor;
    double rgb[3] = { fixed[0], fixed[1], fixed[2] };
    if (arrays.OfNodes && (!isRegular || arrays.NodesAlongBranches))
    {
      ColorOfId(arrays.OfNodes, node, rgb);
    }
    const double radius = this->BallRadius * diagonal * (isRegular ? RegularBall : 1.0);
    AppendBall(skeleton->GetPoint(node), radius, rgb, append);
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    output->ShallowCopy(append->GetOutput());
    output->GetCellData()->SetActiveScalars("Color");
  }
  return 1;
}

void vtkMarrowSkeletonGlyphs::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const names[] = { "NodeType", "Correspondence", "Branch", "Label" };
  os << indent << "ColorBy: " << names[this->ColorBy] << "\n";
  os << indent << "LabelArrayName: " << (this->LabelArrayName ? this->LabelArrayName : "(none)")
     << "\n";
  os << indent << "ShowRegularNodes: " << this->ShowRegularNodes << "\n";
  os << indent << "TubeRadius: " << this->TubeRadius << "\n";
  os << indent << "BallRadius: " << this->BallRadius << "\n";
}
