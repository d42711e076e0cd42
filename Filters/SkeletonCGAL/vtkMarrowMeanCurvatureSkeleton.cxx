// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowMeanCurvatureSkeleton.h"

#include "FilterSupport.h"
#include "MeanCurvatureSkeleton.h"
#include "MeshCheck.h"
#include "NodeMeasures.h"
#include "SkeletonRequest.h"

#include <vtkObjectFactory.h>

#include <string>

vtkStandardNewMacro(vtkMarrowMeanCurvatureSkeleton);

vtkMarrowMeanCurvatureSkeleton::vtkMarrowMeanCurvatureSkeleton()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkMarrowMeanCurvatureSkeleton::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  marrow::SkeletonRequest request;
  // What CGAL's flow asks of a mesh.
  request.Check = [](const marrow::MeshReport& report) { return report.ClosedError(); };
  request.ProgressAfterMeasures = 0.1;
  request.Compute = [this](const marrow::TriangleMesh& mesh, const marrow::VertexMeasures& measures,
                      const marrow::Progress& progress, marrow::Skeleton& skeleton)
  {
    marrow::MeanCurvatureWeights weights;
    weights.QualitySpeedTradeoff = this->QualitySpeedTradeoff;
    weights.MediallyCenteredSpeedTradeoff = this->MediallyCenteredSpeedTradeoff;
    std::string error = marrow::ComputeMeanCurvatureSkeleton(mesh, weights, skeleton, progress);
    if (error.empty() && !marrow::IsAborted(this))
    {
      marrow::AverageMeasures(skeleton, mesh, measures);
    }
    return error;
  };
  return marrow::RunSkeletonRequest(this, request, inputVector, outputVector);
}

void vtkMarrowMeanCurvatureSkeleton::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "QualitySpeedTradeoff: " << this->QualitySpeedTradeoff << "\n";
  os << indent << "MediallyCenteredSpeedTradeoff: " << this->MediallyCenteredSpeedTradeoff << "\n";
}
