// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonRequest.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "NodeMeasures.h"
#include "RequiredMeasures.h"
#include "SkeletonBridge.h"

#include <vtkAlgorithm.h>
#include <vtkInformationVector.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace marrow
{
int RunSkeletonRequest(vtkAlgorithm* filter, const SkeletonRequest& request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* skeletonOutput = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* meshOutput = vtkPolyData::GetData(outputVector, 1);
  if (IsIdleProcess(outputVector, input))
  {
    return 1;
  }

  TriangleMesh mesh;
  MeshReport report;
  std::string error = ToManifoldMesh(input, mesh, report);
  if (error.empty())
  {
    error = request.Check(report);
  }
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(filter, << error);
    return 0;
  }

  meshOutput->ShallowCopy(input);
  SkeletonMeasures measures;
  error = RequireMeasures(filter, 0.0, request.ProgressAfterMeasures, meshOutput, measures);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(filter, << error);
    return 0;
  }
  if (IsAborted(filter))
  {
    return 1;
  }

  Skeleton skeleton;
  error = request.Compute(
    mesh, measures, ProgressOf(filter, request.ProgressAfterMeasures, 1.0), skeleton);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(filter, << error);
    return 0;
  }
  if (IsAborted(filter))
  {
    return 1;
  }
  ToPolyData(skeleton, skeletonOutput);
  SetIdArray(meshOutput->GetPointData(), names::SkeletonNodeId,
    NodeOfVertices(skeleton, mesh.NumberOfVertices()));
  return 1;
}
}
