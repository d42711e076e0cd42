// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMSPField.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "PreparedSurface.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkMSPField);

int vtkMSPField::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }

  constexpr double progressAfterSurface = 0.05;
  marrow::PreparedSurface surface;
  const std::string error = marrow::PrepareSurface(input, this->MaximumFaces,
    marrow::BodyMode::Apart, surface, marrow::ProgressOf(this, 0.0, progressAfterSurface));
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  output->ShallowCopy(input);
  if (marrow::IsAborted(this))
  {
    return 1; // the mesh passes without the measures
  }
  marrow::WriteNote(surface, output);

  const marrow::MeasureParameters parameters = { this->NumberOfSlices,
    this->AGDMethod == ALL_PAIRS ? marrow::GeodesicSources::AllVertices
                                 : marrow::GeodesicSources::Sampled };
  std::vector<marrow::VertexMeasures> measures(surface.Bodies.size());
  const double span = (1.0 - progressAfterSurface) / static_cast<double>(measures.size());
  for (std::size_t b = 0; b < measures.size(); ++b)
  {
    const double begin = progressAfterSurface + span * static_cast<double>(b);
    if (!marrow::MeasureBody(surface.Bodies[b], parameters, measures[b],
          marrow::ProgressOf(this, begin, begin + span)))
    {
      return 1;
    }
  }
  marrow::WriteMeasures(surface, measures, output);
  if (!output->GetPointData()->GetScalars())
  {
    output->GetPointData()->SetActiveScalars(marrow::names::MSP);
  }
  return 1;
}

void vtkMSPField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSlices: " << this->NumberOfSlices << "\n";
  os << indent << "AGDMethod: " << (this->AGDMethod == ALL_PAIRS ? "ALL_PAIRS" : "SAMPLED") << "\n";
  os << indent << "MaximumFaces: " << this->MaximumFaces << "\n";
}
