// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_YSkeleton_h
#define marrow_YSkeleton_h

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace marrow::test
{
/// A Y of four points: a junction and three terminals, in a mesh of diagonal 10.
inline vtkSmartPointer<vtkPolyData> YSkeleton()
{
  auto skeleton = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(0, -1, 0);
  points->InsertNextPoint(1, 1, 0);
  points->InsertNextPoint(-1, 1, 0);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> types;
  types->SetName("NodeType");
  types->InsertNextValue(3);
  vtkNew<vtkIdTypeArray> nodeIds;
  nodeIds->SetName("CorrespondenceId");
  nodeIds->InsertNextValue(0);
  vtkNew<vtkIdTypeArray> branchIds;
  branchIds->SetName("BranchCorrespondenceId");
  for (int i = 1; i < 4; ++i)
  {
    lines->InsertNextCell({ 0, i });
    types->InsertNextValue(1);
    nodeIds->InsertNextValue(i < 3 ? i : -1);
    branchIds->InsertNextValue(i < 3 ? i : -1);
  }
  skeleton->SetPoints(points);
  skeleton->SetLines(lines);
  skeleton->GetPointData()->AddArray(types);
  skeleton->GetPointData()->AddArray(nodeIds);
  skeleton->GetCellData()->AddArray(branchIds);
  vtkNew<vtkDoubleArray> diagonal;
  diagonal->SetName("MeshDiagonal");
  diagonal->InsertNextValue(10.0);
  skeleton->GetFieldData()->AddArray(diagonal);
  return skeleton;
}
}

#endif
