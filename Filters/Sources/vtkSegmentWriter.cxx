// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentWriter.h"

#include "ArrayNames.h"
#include "SegmentFile.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkSegmentWriter);

vtkSegmentWriter::vtkSegmentWriter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

vtkSegmentWriter::~vtkSegmentWriter()
{
  this->SetFileName(nullptr);
}

int vtkSegmentWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkSegmentWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: set FileName.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  auto* input = vtkPolyData::SafeDownCast(this->GetInput());
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* array = this->GetInputArrayToProcess(0, input);
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != input->GetNumberOfCells())
  {
    vtkErrorMacro("The mesh has no cell array \""
      << (name ? name : "") << "\" with one component and a value for each of its "
      << input->GetNumberOfCells()
      << " cells: choose the array that holds the segments with SetInputArrayToProcess.");
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return;
  }
  std::vector<int> segments(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetTuple1(i);
    if (!(value >= VTK_INT_MIN && value <= VTK_INT_MAX) || value != std::floor(value))
    {
      vtkErrorMacro("The cell array \"" << (name ? name : "") << "\" holds " << value << " at cell "
                                        << i
                                        << ", which is no integer that an int holds: choose "
                                           "another array with SetInputArrayToProcess.");
      this->SetErrorCode(vtkErrorCode::UnknownError);
      return;
    }
    segments[i] = static_cast<int>(value);
  }
  const std::string error = marrow::WriteSegmentFile(this->FileName, segments);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
  }
}

void vtkSegmentWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
