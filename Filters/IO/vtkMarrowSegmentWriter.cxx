// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSegmentWriter.h"

#include "ArrayNames.h"
#include "LabelBridge.h"
#include "OutputFile.h"
#include "SegmentFile.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkMarrowSegmentWriter);

vtkMarrowSegmentWriter::vtkMarrowSegmentWriter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

vtkMarrowSegmentWriter::~vtkMarrowSegmentWriter()
{
  this->SetFileName(nullptr);
}

int vtkMarrowSegmentWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkMarrowSegmentWriter::WriteData()
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
  if (!array)
  {
    vtkErrorMacro("The mesh has no cell array \""
      << (name ? name : "")
      << "\": choose the array that holds the segments with SetInputArrayToProcess.");
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return;
  }
  std::vector<int> segments;
  std::string error = marrow::ToLabels(array, input->GetNumberOfCells(), "cell", segments);
  if (!error.empty())
  {
    vtkErrorMacro("The segments cannot be written: " << error);
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return;
  }
  error = marrow::WriteOutputFile(this->FileName, marrow::SegmentFileText(segments));
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
  }
}

const char* vtkMarrowSegmentWriter::GetFileExtensions()
{
  return ".seg";
}

void vtkMarrowSegmentWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
