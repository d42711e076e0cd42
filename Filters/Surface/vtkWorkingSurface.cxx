// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWorkingSurface.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "SurfaceBridge.h"
#include "WorkingSurface.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkWorkingSurface);

namespace
{
void SetTriangles(const marrow::TriangleMesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfVertices());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    points->SetPoint(v, mesh.Points[v].data());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.NumberOfTriangles(), 3 * mesh.NumberOfTriangles());
  for (const auto& triangle : mesh.Triangles)
  {
    triangles->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
}

void SetReport(const marrow::WorkingSurface& surface, vtkPolyData* output)
{
  for (const auto& entry : surface.Report.Entries())
  {
    vtkNew<vtkIntArray> count;
    count->SetName(entry.Name);
    count->InsertNextValue(entry.Count);
    output->GetFieldData()->AddArray(count);
  }
  marrow::SetNote(surface.Sentence(), output);
}
}

vtkWorkingSurface::vtkWorkingSurface()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkWorkingSurface::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* working = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* mapped = vtkPolyData::GetData(outputVector, 1);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }

  const marrow::SurfaceOfPolyData faces = marrow::ToPolygonMesh(input);
  marrow::WorkingSurfaceParameters parameters;
  parameters.MaximumFaces = this->MaximumFaces;
  marrow::WorkingSurface surface;
  const std::string error =
    marrow::ComputeWorkingSurface(faces.Mesh, parameters, marrow::ProgressOf(this), surface);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  surface.Report.OtherCells = faces.NumberOfOtherCells;
  mapped->ShallowCopy(input);
  if (marrow::IsAborted(this))
  {
    return 1; // the input passes without the arrays
  }

  const bool passes =
    surface.IsInput && faces.NumberOfOtherCells == 0 && input->GetNumberOfStrips() == 0;
  if (passes)
  {
    working->ShallowCopy(input);
  }
  else
  {
    SetTriangles(surface.Mesh, working);
  }
  marrow::SetIntArray(working->GetCellData(), marrow::names::BodyId, surface.BodyOfTriangle);

  std::vector<int> triangleOfCell(faces.PolygonOfCell.size(), -1);
  for (std::size_t c = 0; c < triangleOfCell.size(); ++c)
  {
    if (faces.PolygonOfCell[c] >= 0)
    {
      triangleOfCell[c] = surface.TriangleOfCell(faces.PolygonOfCell[c]);
    }
  }
  marrow::SetIdArray(mapped->GetCellData(), marrow::names::WorkingTriangleId, triangleOfCell);
  marrow::SetIdArray(mapped->GetPointData(), marrow::names::WorkingVertexId, surface.VertexOfPoint);
  SetReport(surface, working);
  SetReport(surface, mapped);
  return 1;
}

void vtkWorkingSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumFaces: " << this->MaximumFaces << "\n";
}
