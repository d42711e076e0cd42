// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMSPField.h"

#include "ArrayNames.h"
#include "AverageGeodesicDistance.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "MinimumSlicePerimeter.h"
#include "SurfaceMeasures.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkMSPField);

namespace
{
constexpr int NumberOfSampledSources = 64;

/// The share of the time that goes into AGD, as measured from 5,000 to 1,000,000 faces: the time for
/// slices grows faster with the mesh.
double ShareOfAGD(int numberOfVertices, int numberOfSources, int numberOfSlices)
{
  const double sources = numberOfSources / 64.0;
  const double slices = numberOfSlices / 12.0 * std::pow(numberOfVertices / 1.0e4, 0.3);
  return sources / (sources + slices);
}
}

int vtkMSPField::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }

  marrow::TriangleMesh mesh;
  marrow::MeshReport report;
  const std::string error = marrow::ToManifoldMesh(input, mesh, report);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  output->ShallowCopy(input);

  std::vector<double> averageDistance;
  marrow::SliceField slices;
  const bool allPairs = this->AGDMethod == ALL_PAIRS;
  const double share = ShareOfAGD(mesh.NumberOfVertices(),
    allPairs ? mesh.NumberOfVertices() : NumberOfSampledSources, this->NumberOfSlices);
  if (!marrow::ComputeAverageGeodesicDistance(mesh, allPairs ? 0 : NumberOfSampledSources,
        averageDistance, marrow::ProgressOf(this, 0.0, share)) ||
    !marrow::ComputeMinimumSlicePerimeter(
      mesh, this->NumberOfSlices, slices, marrow::ProgressOf(this, share, 1.0)))
  {
    return 1; // aborted: the mesh passes without the measures
  }

  vtkPointData* points = output->GetPointData();
  marrow::SetArray(points, marrow::names::AGD, averageDistance);
  marrow::SetArray(points, marrow::names::MSP, slices.Perimeter);
  marrow::SetArray(points, marrow::names::MSPCenter, slices.Center);
  marrow::SetArray(points, marrow::names::MSPNormal, slices.Normal);
  marrow::SetArray(points, marrow::names::MSPValid, slices.Valid);
  marrow::SetArray(
    points, marrow::names::MSPGradient, marrow::VertexGradient(mesh, slices.Perimeter));
  marrow::SetArray(points, marrow::names::DihedralAngle, marrow::VertexDihedralAngles(mesh));
  if (!points->GetScalars())
  {
    points->SetActiveScalars(marrow::names::MSP);
  }
  return 1;
}

void vtkMSPField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSlices: " << this->NumberOfSlices << "\n";
  os << indent << "AGDMethod: " << (this->AGDMethod == ALL_PAIRS ? "ALL_PAIRS" : "SAMPLED") << "\n";
}
