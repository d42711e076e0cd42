// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMSPSkeleton.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MSPSkeleton.h"
#include "MeshBridge.h"
#include "RequiredMeasures.h"
#include "SkeletonBridge.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <string>

vtkStandardNewMacro(vtkMSPSkeleton);

namespace
{
constexpr double ProgressAfterMeasures = 0.6;
}

vtkMSPSkeleton::vtkMSPSkeleton()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkMSPSkeleton::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* skeletonOutput = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* meshOutput = vtkPolyData::GetData(outputVector, 1);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }

  marrow::TriangleMesh mesh;
  marrow::MeshReport report;
  std::string error = marrow::ToManifoldMesh(input, mesh, report);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  meshOutput->ShallowCopy(input);
  marrow::SkeletonMeasures measures;
  error = marrow::RequireMeasures(this, 0.0, ProgressAfterMeasures, meshOutput, measures);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (marrow::IsAborted(this))
  {
    return 1;
  }

  const marrow::Skeleton skeleton = marrow::ComputeMSPSkeleton(mesh, measures, this->FinestArea,
    this->NodeSpacing * mesh.BoundingBoxDiagonal(),
    marrow::ProgressOf(this, ProgressAfterMeasures, 1.0));
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  marrow::ToPolyData(skeleton, skeletonOutput);
  marrow::SetIdArray(meshOutput->GetPointData(), marrow::names::SkeletonNodeId,
    marrow::NodeOfVertices(skeleton, mesh.NumberOfVertices()));
  return 1;
}

void vtkMSPSkeleton::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FinestArea: " << this->FinestArea << "\n";
  os << indent << "NodeSpacing: " << this->NodeSpacing << "\n";
}
