// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowMeshReader.h"

#include "FileContent.h"
#include "FileExtension.h"
#include "FileMeshBridge.h"
#include "FilterSupport.h"
#include "ObjFile.h"
#include "OffFile.h"
#include "PlyFile.h"
#include "StlFile.h"
#include "SurfaceOfDataSet.h"
#include "VTKFile.h"

#include <vtkDataSet.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <new>

vtkStandardNewMacro(vtkMarrowMeshReader);

namespace
{
using Parser = std::string (*)(
  std::string_view, std::string_view, marrow::FileMesh&, const marrow::Progress&);

/// The parser of the format; none for those of VTK.
Parser ParserOf(const std::string& extension)
{
  return extension == ".off" ? marrow::ReadOffFile
    : extension == ".ply"    ? marrow::ReadPlyFile
    : extension == ".obj"    ? marrow::ReadObjFile
    : extension == ".stl"    ? marrow::ReadStlFile
                             : nullptr;
}

std::string Read(const std::string& fileName, vtkPolyData* output, const marrow::Progress& progress)
{
  std::string content;
  std::string error = marrow::ReadFileContent(fileName, content);
  if (!error.empty())
  {
    return error;
  }
  const std::string extension = marrow::ExtensionOfFormat(fileName);
  if (const Parser parse = ParserOf(extension))
  {
    marrow::FileMesh mesh;
    error = parse(content, fileName, mesh, marrow::SubProgress(progress, 0.0, 0.7));
    content = std::string();
    if (error.empty() && marrow::Report(progress, 0.8))
    {
      marrow::ToPolyData(mesh, output);
    }
  }
  else
  {
    vtkSmartPointer<vtkDataSet> data;
    error = marrow::ReadVTKFile(content, fileName, data);
    if (error.empty())
    {
      marrow::ToSurface(data, output);
    }
  }
  return error;
}
}

vtkMarrowMeshReader::vtkMarrowMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMarrowMeshReader::~vtkMarrowMeshReader()
{
  this->SetFileName(nullptr);
}

const char* vtkMarrowMeshReader::GetFileExtensions()
{
  return ".off .ply .obj .stl .vtp .vtu .vtk .off.gz .ply.gz .obj.gz .stl.gz .vtk.gz";
}

int vtkMarrowMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no file name: set FileName.");
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  std::string error = marrow::CheckExtension(this->FileName, GetFileExtensions());
  try
  {
    error = error.empty() ? Read(this->FileName, output, marrow::ProgressOf(this)) : error;
  }
  catch (const std::bad_alloc&)
  {
    error = std::string("There is not enough memory to read \"") + this->FileName + "\".";
  }
  const bool isEmpty = output->GetNumberOfPolys() == 0 || output->GetNumberOfPoints() == 0;
  if (error.empty() && isEmpty && !marrow::IsAborted(this))
  {
    error = std::string("\"") + this->FileName + "\" holds no surface: it has no faces.";
  }
  if (!error.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  this->UpdateProgress(1.0);
  return 1;
}

void vtkMarrowMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
