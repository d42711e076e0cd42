// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeanCurvatureSkeleton.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MeanCurvatureSkeleton.h"
#include "MeshBridge.h"
#include "NodeMeasures.h"
#include "RequiredMeasures.h"
#include "SkeletonBridge.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <string>

vtkStandardNewMacro(vtkMeanCurvatureSkeleton);

namespace
{
constexpr double ProgressAfterMeasures = 0.1;

/// As marrow::ToManifoldMesh, for what CGAL's flow asks of a mesh.
std::string ToClosedConnectedMesh(vtkPolyData* input, marrow::TriangleMesh& mesh)
{
  marrow::MeshReport report;
  std::string error = marrow::ToManifoldMesh(input, mesh, report);
  if (error.empty())
  {
    error = report.ClosedError();
  }
  return error.empty() ? report.ConnectedError() : error;
}
}

vtkMeanCurvatureSkeleton::vtkMeanCurvatureSkeleton()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkMeanCurvatureSkeleton::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* skeletonOutput = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* meshOutput = vtkPolyData::GetData(outputVector, 1);

  marrow::TriangleMesh mesh;
  std::string error = ToClosedConnectedMesh(input, mesh);
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

  marrow::MeanCurvatureWeights weights;
  weights.QualitySpeedTradeoff = this->QualitySpeedTradeoff;
  weights.MediallyCenteredSpeedTradeoff = this->MediallyCenteredSpeedTradeoff;
  marrow::Skeleton skeleton;
  error = marrow::ComputeMeanCurvatureSkeleton(
    mesh, weights, skeleton, marrow::ProgressOf(this, ProgressAfterMeasures, 1.0));
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  marrow::AverageMeasures(skeleton, mesh, measures);
  marrow::ToPolyData(skeleton, skeletonOutput);
  marrow::SetIdArray(meshOutput->GetPointData(), marrow::names::SkeletonNodeId,
    marrow::NodeOfVertices(skeleton, mesh.NumberOfVertices()));
  return 1;
}

void vtkMeanCurvatureSkeleton::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "QualitySpeedTradeoff: " << this->QualitySpeedTradeoff << "\n";
  os << indent << "MediallyCenteredSpeedTradeoff: " << this->MediallyCenteredSpeedTradeoff << "\n";
}
