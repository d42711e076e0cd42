// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCreatureSource.h"

#include "ArrayNames.h"
#include "CreatureMesh.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkCreatureSource);

vtkCreatureSource::vtkCreatureSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

int vtkCreatureSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  marrow::CreatureParameters parameters;
  parameters.Kind = static_cast<marrow::CreatureKind>(this->Shape);
  parameters.Pose = this->Pose;
  parameters.Proportion = this->Proportion;
  parameters.Resolution = this->Resolution;
  parameters.Noise = this->Noise;
  parameters.Seed = static_cast<unsigned int>(this->Seed);

  marrow::CreatureMesh creature;
  const std::string error =
    marrow::MakeCreatureMesh(parameters, creature, marrow::ProgressOf(this));
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  const marrow::TriangleMesh& mesh = creature.Mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfVertices());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    points->SetPoint(v, mesh.Points[v].data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& triangle : mesh.Triangles)
  {
    polygons->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  vtkPolyData* surface = vtkPolyData::GetData(outputVector, 0);
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  marrow::SetIntArray(surface->GetCellData(), marrow::names::SegmentId, creature.SegmentIds);
  surface->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  marrow::SetIdArray(surface->GetPointData(), marrow::names::SkeletonNodeId,
    marrow::NodeOfVertices(creature.KnownSkeleton, mesh.NumberOfVertices()));

  vtkPolyData* skeleton = vtkPolyData::GetData(outputVector, 1);
  marrow::ToPolyData(creature.KnownSkeleton, skeleton);
  // Nobody measured them, and zeros would pass for measured.
  skeleton->GetPointData()->RemoveArray(marrow::names::AGD);
  skeleton->GetPointData()->RemoveArray(marrow::names::MSP);
  skeleton->GetFieldData()->RemoveArray(marrow::names::MeshMaximumMSP);
  return 1;
}

void vtkCreatureSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "Pose: " << this->Pose << "\n";
  os << indent << "Proportion: " << this->Proportion << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Noise: " << this->Noise << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
