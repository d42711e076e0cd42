// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowMeshWriter.h"

#include "ArrayNames.h"
#include "FileExtension.h"
#include "FileMeshBridge.h"
#include "LabelBridge.h"
#include "MeshText.h"
#include "OutputFile.h"
#include "StringArrays.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <limits>

vtkStandardNewMacro(vtkMarrowMeshWriter);

namespace
{
std::string XMLContent(vtkPolyData* mesh)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

std::string LegacyContent(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileTypeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputStdString();
}

/// What keeps a mesh from a format of points and faces; empty if nothing does.
std::string CheckPolygons(vtkPolyData* mesh)
{
  const vtkIdType others = mesh->GetNumberOfCells() - mesh->GetNumberOfPolys();
  if (others > 0)
  {
    return "The mesh has " + std::to_string(others) +
      " cells that are no polygons, for which the format has no place: write a .vtp file.";
  }
  if (mesh->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    return "The mesh has more points than the format can number: write a .vtp file.";
  }
  return {};
}
}

vtkMarrowMeshWriter::vtkMarrowMeshWriter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

vtkMarrowMeshWriter::~vtkMarrowMeshWriter()
{
  this->SetFileName(nullptr);
}

const char* vtkMarrowMeshWriter::GetFileExtensions()
{
  return ".off .ply .obj .vtp .vtk";
}

int vtkMarrowMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkMarrowMeshWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: set FileName.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  auto* mesh = vtkPolyData::SafeDownCast(this->GetInput());
  const std::string extension = marrow::ExtensionOfFormat(this->FileName);
  const bool isOfVTK = extension == ".vtp" || extension == ".vtk";
  std::string error = marrow::CheckExtension(this->FileName, GetFileExtensions());
  marrow::FileSegments segments;
  if (error.empty() && !isOfVTK)
  {
    error = CheckPolygons(mesh);
    vtkDataArray* array = this->GetInputArrayToProcess(0, mesh);
    if (error.empty() && array)
    {
      error = marrow::ToLabels(array, mesh->GetNumberOfCells(), "cell", segments.Labels);
    }
    segments.NameOfLabel = marrow::GetStrings(mesh->GetFieldData(), marrow::names::SegmentName);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return;
  }
  const std::string content = extension == ".vtp" ? XMLContent(mesh)
    : extension == ".vtk"                         ? LegacyContent(mesh)
    : extension == ".off" ? marrow::OffFileContent(marrow::ToFileMesh(mesh), segments)
    : extension == ".ply" ? marrow::PlyFileContent(marrow::ToFileMesh(mesh), segments)
                          : marrow::ObjFileContent(marrow::ToFileMesh(mesh), segments);
  error = marrow::WriteOutputFile(this->FileName, content);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
  }
}

void vtkMarrowMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
