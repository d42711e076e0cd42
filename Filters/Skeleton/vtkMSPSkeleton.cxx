// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMSPSkeleton.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MSPSkeleton.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMSPField.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkMSPSkeleton);

namespace
{
constexpr double ProgressAfterMeasures = 0.6;

bool GetMeasures(vtkPolyData* mesh, marrow::SkeletonMeasures& measures)
{
  vtkPointData* points = mesh->GetPointData();
  const int size = static_cast<int>(mesh->GetNumberOfPoints());
  return marrow::GetArray(points, marrow::names::AGD, size, measures.AGD) &&
    marrow::GetArray(points, marrow::names::MSP, size, measures.MSP) &&
    marrow::GetArray(points, marrow::names::MSPCenter, size, measures.MSPCenter) &&
    marrow::GetArray(points, marrow::names::MSPValid, size, measures.MSPValid);
}

/// One sentence on the first measure that is not finite; empty if all are.
std::string FiniteError(const marrow::SkeletonMeasures& measures)
{
  const auto sentence = [](const char* name, std::size_t point)
  {
    return std::string("The array \"") + name + "\" of the mesh is not finite at point " +
      std::to_string(point) + ": remove the array, and it is computed anew.";
  };
  for (std::size_t i = 0; i < measures.MSP.size(); ++i)
  {
    if (!std::isfinite(measures.AGD[i]))
    {
      return sentence(marrow::names::AGD, i);
    }
    if (!std::isfinite(measures.MSP[i]))
    {
      return sentence(marrow::names::MSP, i);
    }
    if (!measures.MSPCenter[i].allFinite())
    {
      return sentence(marrow::names::MSPCenter, i);
    }
  }
  return {};
}
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
  if (!GetMeasures(meshOutput, measures))
  {
    vtkNew<vtkMSPField> field;
    marrow::WatchInner(this, field, 0.0, ProgressAfterMeasures);
    field->SetInputData(input);
    field->Update();
    if (marrow::IsAborted(this))
    {
      return 1;
    }
    meshOutput->ShallowCopy(field->GetOutput());
    if (!GetMeasures(meshOutput, measures))
    {
      vtkErrorMacro(
        "The measures of the mesh could not be computed: see the message of vtkMSPField.");
      return 0;
    }
  }
  error = FiniteError(measures);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
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
