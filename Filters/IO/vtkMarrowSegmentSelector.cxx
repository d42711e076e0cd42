// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSegmentSelector.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "MeshLabels.h"
#include "StringArrays.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkMarrowSegmentSelector);

vtkMarrowSegmentSelector::vtkMarrowSegmentSelector()
{
  this->SetLabels(marrow::names::SegmentId);
}

vtkMarrowSegmentSelector::~vtkMarrowSegmentSelector()
{
  this->SetLabels(nullptr);
}

int vtkMarrowSegmentSelector::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }
  marrow::MeshLabels labels;
  const std::string error = marrow::SelectLabels(input, this->Labels ? this->Labels : "", labels);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  output->ShallowCopy(input);
  marrow::SetIntArray(output->GetCellData(), marrow::names::SegmentId, labels.Ids);
  marrow::SetStrings(output->GetFieldData(), marrow::names::SegmentName, labels.NameOfId);
  output->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  return 1;
}

void vtkMarrowSegmentSelector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Labels: " << (this->Labels ? this->Labels : "(none)") << "\n";
}
