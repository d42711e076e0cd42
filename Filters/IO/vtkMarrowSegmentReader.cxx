// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSegmentReader.h"

#include "ArrayNames.h"
#include "FileContent.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "SegmentFile.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkMarrowSegmentReader);

vtkMarrowSegmentReader::~vtkMarrowSegmentReader()
{
  this->SetFileName(nullptr);
}

int vtkMarrowSegmentReader::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (marrow::IsIdleProcess(outputVector, input))
  {
    return 1;
  }
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: set FileName.");
    return 0;
  }
  std::vector<int> segments;
  std::string content;
  std::string error = marrow::ReadFileContent(this->FileName, content);
  if (error.empty())
  {
    error = marrow::ReadSegmentFile(content, this->FileName, segments);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (static_cast<vtkIdType>(segments.size()) != input->GetNumberOfCells())
  {
    vtkErrorMacro("\"" << this->FileName << "\" has " << segments.size()
                       << " segment numbers but the mesh has " << input->GetNumberOfCells()
                       << " cells: use the file that belongs to this mesh.");
    return 0;
  }
  output->ShallowCopy(input);
  marrow::SetIntArray(output->GetCellData(), marrow::names::SegmentId, segments);
  output->GetFieldData()->RemoveArray(marrow::names::SegmentName);
  output->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  return 1;
}

const char* vtkMarrowSegmentReader::GetFileExtensions()
{
  return ".seg .seg.gz";
}

void vtkMarrowSegmentReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
