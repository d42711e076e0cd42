// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionFolder.h"

#include "CommandError.h"
#include "Console.h"
#include "MeshFiles.h"

#include <vtkCellData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

namespace fs = std::filesystem;

namespace
{
bool IsMeshFile(const fs::path& path)
{
  std::string name = path.filename().string();
  if (files::Extension(name) == ".gz")
  {
    name = fs::path(name).stem().string();
  }
  const std::string ending = files::Extension(name);
  std::istringstream readable(files::ReadableMeshes());
  for (std::string known; readable >> known;)
  {
    if (!ending.empty() && known == ending)
    {
      return true;
    }
  }
  return false;
}

void Read(CollectionEntry& entry, const std::string& labels, Console& console)
{
  if (!entry.Segments.empty())
  {
    entry.Mesh = files::ReadSegmented(entry.File, { entry.Segments, "SegmentId" }, console);
    return;
  }
  entry.Mesh = files::ReadMesh(entry.File, console);
  if (labels.empty())
  {
    return;
  }
  try
  {
    entry.Mesh = files::ReadSegmented(entry.File, { "", labels }, console);
  }
  catch (const CommandError&)
  {
    // A mesh without these labels is one to be labelled; one of that name left from elsewhere is not.
    auto unlabelled = vtkSmartPointer<vtkPolyData>::New();
    unlabelled->ShallowCopy(entry.Mesh);
    unlabelled->GetCellData()->RemoveArray("SegmentId");
    entry.Mesh = unlabelled;
  }
}
}

std::vector<CollectionEntry> ReadCollection(
  const std::string& folder, const std::string& labels, Console& console)
{
  std::error_code error;
  std::vector<fs::path> paths;
  for (const auto& found : fs::directory_iterator(folder, error))
  {
    if (found.is_regular_file() && IsMeshFile(found.path()))
    {
      paths.push_back(found.path());
    }
  }
  if (error)
  {
    throw CommandError(folder + ": the folder cannot be read.");
  }
  if (paths.empty())
  {
    throw CommandError(
      folder + ": there is no mesh in it; known are " + files::ReadableMeshes() + ".");
  }
  std::sort(paths.begin(), paths.end());
  std::vector<CollectionEntry> entries;
  std::map<std::string, std::string> fileOfName;
  for (const fs::path& path : paths)
  {
    CollectionEntry entry;
    entry.File = path.string();
    entry.Name = files::Stem(entry.File);
    const fs::path segments = path.parent_path() / (entry.Name + ".seg");
    entry.Segments = fs::exists(segments) ? segments.string() : "";
    const auto [other, isFree] = fileOfName.emplace(entry.Name, entry.File);
    try
    {
      if (!isFree)
      {
        throw CommandError(
          entry.File + ": it has the name of " + other->second + " and is left out: rename one.");
      }
      Read(entry, labels, console);
    }
    catch (const std::exception& failure)
    {
      entry.Error = failure.what();
      entry.Mesh = nullptr;
    }
    entries.push_back(entry);
  }
  return entries;
}
