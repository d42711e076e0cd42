// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMSPSkeleton.h"

#include "MSPSkeleton.h"
#include "SkeletonRequest.h"

#include <vtkObjectFactory.h>

#include <string>

vtkStandardNewMacro(vtkMSPSkeleton);

vtkMSPSkeleton::vtkMSPSkeleton()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkMSPSkeleton::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  marrow::SkeletonRequest request;
  request.MaximumFaces = this->MaximumFaces;
  // Most of the time goes into the measures.
  request.ProgressAfterMeasures = 0.6;
  request.Compute = [this](const marrow::TriangleMesh& mesh, const marrow::VertexMeasures& measures,
                      const marrow::Progress& progress, marrow::Skeleton& skeleton)
  {
    skeleton = marrow::ComputeMSPSkeleton(
      mesh, measures, this->FinestArea, this->NodeSpacing * mesh.BoundingBoxDiagonal(), progress);
    return std::string();
  };
  return marrow::RunSkeletonRequest(this, request, inputVector, outputVector);
}

void vtkMSPSkeleton::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FinestArea: " << this->FinestArea << "\n";
  os << indent << "NodeSpacing: " << this->NodeSpacing << "\n";
  os << indent << "MaximumFaces: " << this->MaximumFaces << "\n";
}
