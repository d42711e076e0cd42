// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "CommandError.h"
#include "Console.h"

#include <vtkCleanPolyData.h>
#include <vtkOBJReader.h>
#include <vtkOFFReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSegmentReader.h>
#include <vtkSegmentWriter.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace files
{
namespace
{
void RequireReadable(const std::string& path)
{
  if (!std::filesystem::exists(path))
  {
    throw CommandError(path + ": there is no such file.");
  }
  if (std::filesystem::is_directory(path) || !std::ifstream(path))
  {
    throw CommandError(path + ": the file cannot be read.");
  }
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> Read(const std::string& path, Console& console)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  console.Update(reader, path);
  return reader->GetOutput();
}

/// Keeps triangles that collapse: the check of the mesh names them, silence would renumber the
/// rest.
vtkSmartPointer<vtkPolyData> MergePoints(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(mesh);
  clean->SetTolerance(0.0);
  clean->ConvertLinesToPointsOff();
  clean->ConvertPolysToLinesOff();
  clean->ConvertStripsToPolysOff();
  clean->Update();
  return clean->GetOutput();
}

/// Leaves a mesh of nothing but triangles untouched, and so its degenerate triangles too.
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* mesh)
{
  const bool triangles = mesh->GetNumberOfVerts() == 0 && mesh->GetNumberOfLines() == 0 &&
    mesh->GetNumberOfStrips() == 0 && mesh->GetPolys()->IsHomogeneous() == 3;
  if (triangles)
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(mesh);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  return triangulate->GetOutput();
}

void Write(vtkWriter* writer, const std::string& path, Console& console)
{
  writer->Write();
  console.ThrowIfError(path);
}
}

vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& path, Console& console)
{
  RequireExtension(path, { ".off", ".ply", ".obj", ".stl", ".vtp", ".vtk" });
  RequireReadable(path);
  const std::string extension = Extension(path);
  vtkSmartPointer<vtkPolyData> mesh;
  if (extension == ".off")
  {
    mesh = Read<vtkOFFReader>(path, console);
  }
  else if (extension == ".ply")
  {
    mesh = Read<vtkPLYReader>(path, console);
  }
  else if (extension == ".obj")
  {
    mesh = MergePoints(Read<vtkOBJReader>(path, console));
  }
  else if (extension == ".stl")
  {
    mesh = MergePoints(Read<vtkSTLReader>(path, console));
  }
  else
  {
    mesh = ReadPolyData(path, console);
  }
  mesh = Triangulate(mesh);
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw CommandError(path + ": the file holds no surface.");
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path, Console& console)
{
  RequireExtension(path, { ".vtp", ".vtk" });
  RequireReadable(path);
  return Extension(path) == ".vtp" ? Read<vtkXMLPolyDataReader>(path, console)
                                   : Read<vtkPolyDataReader>(path, console);
}

vtkSmartPointer<vtkPolyData> ReadSegments(
  vtkPolyData* mesh, const std::string& path, Console& console)
{
  RequireReadable(path);
  vtkNew<vtkSegmentReader> reader;
  reader->SetInputData(mesh);
  reader->SetFileName(path.c_str());
  console.Update(reader, path);
  return vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
}

void WritePolyData(vtkPolyData* data, const std::string& path, Console& console)
{
  RequireExtension(path, { ".vtp", ".vtk" });
  RequireWritable(path);
  if (Extension(path) == ".vtp")
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    writer->Write();
    console.ThrowIfError(path);
    return;
  }
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  writer->SetInputData(data);
  Write(writer, path, console);
}

void WriteSegments(vtkPolyData* mesh, const std::string& path, Console& console)
{
  RequireWritable(path);
  vtkNew<vtkSegmentWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(mesh);
  Write(writer, path, console);
}

std::ofstream Create(const std::string& path)
{
  RequireWritable(path);
  return std::ofstream(path);
}

std::string Extension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string Stem(const std::string& path)
{
  return std::filesystem::path(path).stem().string();
}

void RequireExtension(const std::string& path, const std::vector<std::string>& allowed)
{
  const std::string extension = Extension(path);
  if (std::find(allowed.begin(), allowed.end(), extension) == allowed.end())
  {
    std::string list = allowed.front();
    for (std::size_t i = 1; i < allowed.size(); ++i)
    {
      list += (i + 1 < allowed.size() ? ", " : " or ") + allowed[i];
    }
    throw CommandError(path + ": the name must end in " + list + ".");
  }
}

void RequireWritable(const std::string& path)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
  {
    throw CommandError(path + ": there is no folder " + folder.string() + " to write into.");
  }
  const bool isNew = !std::filesystem::exists(path);
  if (!std::ofstream(path, std::ios::app))
  {
    throw CommandError(path + ": the file cannot be written.");
  }
  if (isNew)
  {
    std::filesystem::remove(path);
  }
}

void MakeFolder(const std::string& path)
{
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
  {
    throw CommandError(path + ": the folder cannot be made.");
  }
}
}
