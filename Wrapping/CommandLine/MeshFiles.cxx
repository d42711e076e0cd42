// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "CommandError.h"
#include "Console.h"

#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkMarrowMeshReader.h>
#include <vtkMarrowMeshWriter.h>
#include <vtkMarrowSegmentReader.h>
#include <vtkMarrowSegmentSelector.h>
#include <vtkMarrowSegmentWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkVariant.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace files
{
namespace
{
std::vector<std::string> Words(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

bool IsSegmentFile(const std::string& path)
{
  const std::vector<std::string> endings = Words(vtkMarrowSegmentReader::GetFileExtensions());
  return std::any_of(endings.begin(), endings.end(),
    [&path](const std::string& ending)
    {
      return path.size() >= ending.size() &&
        path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
    });
}

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

vtkSmartPointer<vtkPolyData> SelectSegments(
  vtkPolyData* mesh, const std::string& path, const std::string& labels, Console& console)
{
  vtkNew<vtkMarrowSegmentSelector> selector;
  selector->SetInputData(mesh);
  selector->SetLabels(labels.c_str());
  console.Update(selector, path);
  return selector->GetOutput();
}

/// The mesh with the segments of another of the same faces.
vtkSmartPointer<vtkPolyData> WithSegmentsOf(vtkPolyData* mesh, const std::string& path,
  vtkPolyData* segmented, const std::string& segmentedPath)
{
  if (segmented->GetNumberOfCells() != mesh->GetNumberOfCells())
  {
    throw CommandError(segmentedPath + ": it has " + std::to_string(segmented->GetNumberOfCells()) +
      " faces but " + path + " has " + std::to_string(mesh->GetNumberOfCells()) +
      "; use the file that belongs to this mesh.");
  }
  auto labelled = vtkSmartPointer<vtkPolyData>::New();
  labelled->ShallowCopy(mesh);
  labelled->GetCellData()->AddArray(segmented->GetCellData()->GetArray("SegmentId"));
  if (vtkAbstractArray* names = segmented->GetFieldData()->GetAbstractArray("SegmentName"))
  {
    labelled->GetFieldData()->AddArray(names);
  }
  return labelled;
}

void WriteWith(vtkWriter* writer, vtkPolyData* data, const std::string& path, Console& console)
{
  writer->SetInputData(data);
  writer->Write();
  console.ThrowIfError(path);
}
}

vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& path, Console& console)
{
  vtkNew<vtkMarrowMeshReader> reader;
  reader->SetFileName(path.c_str());
  console.Update(reader, path);
  return reader->GetOutput();
}

void ShowNote(vtkDataObject* output, const std::string& path, const Console& console)
{
  if (vtkAbstractArray* note = output->GetFieldData()->GetAbstractArray("WorkingSurfaceNote"))
  {
    console.ShowNote(path, note->GetVariantValue(0).ToString());
  }
}

vtkSmartPointer<vtkPolyData> ReadSegmented(
  const std::string& path, const SegmentSource& segments, Console& console)
{
  vtkSmartPointer<vtkPolyData> mesh = ReadMesh(path, console);
  if (segments.File.empty())
  {
    mesh = SelectSegments(mesh, path, segments.Labels, console);
  }
  else if (IsSegmentFile(segments.File))
  {
    vtkNew<vtkMarrowSegmentReader> reader;
    reader->SetInputData(mesh);
    reader->SetFileName(segments.File.c_str());
    console.Update(reader, segments.File);
    mesh = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  }
  else
  {
    const vtkSmartPointer<vtkPolyData> segmented =
      SelectSegments(ReadMesh(segments.File, console), segments.File, segments.Labels, console);
    mesh = WithSegmentsOf(mesh, path, segmented, segments.File);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path, Console& console)
{
  RequireExtension(path, { ".vtp", ".vtk" });
  RequireReadable(path);
  const auto read = [&](auto* reader)
  {
    reader->SetFileName(path.c_str());
    console.Update(reader, path);
    return vtkSmartPointer<vtkPolyData>(reader->GetOutput());
  };
  return Extension(path) == ".vtp" ? read(vtkNew<vtkXMLPolyDataReader>().Get())
                                   : read(vtkNew<vtkPolyDataReader>().Get());
}

void Write(vtkPolyData* data, const std::string& path, Console& console)
{
  if (IsSegmentFile(path))
  {
    vtkNew<vtkMarrowSegmentWriter> writer;
    writer->SetFileName(path.c_str());
    WriteWith(writer, data, path, console);
    return;
  }
  vtkNew<vtkMarrowMeshWriter> writer;
  writer->SetFileName(path.c_str());
  WriteWith(writer, data, path, console);
}

void WriteText(const std::string& path, const std::string& text)
{
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
  {
    throw CommandError(
      path + ": the file cannot be written: " + std::strerror(errno) + "; check the space left.");
  }
}

std::string ReadableMeshes()
{
  return vtkMarrowMeshReader::GetFileExtensions();
}

std::vector<std::string> WritableMeshes()
{
  std::vector<std::string> endings = Words(vtkMarrowMeshWriter::GetFileExtensions());
  for (const std::string& ending : Words(vtkMarrowSegmentWriter::GetFileExtensions()))
  {
    endings.push_back(ending);
  }
  return endings;
}

std::vector<std::string> Formats()
{
  std::vector<std::string> formats = WritableMeshes();
  for (std::string& format : formats)
  {
    format.erase(0, 1);
  }
  return formats;
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
  const std::filesystem::path stem = std::filesystem::path(path).stem();
  return Extension(path) == ".gz" ? stem.stem().string() : stem.string();
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
