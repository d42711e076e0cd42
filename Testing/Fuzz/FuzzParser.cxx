// SPDX-License-Identifier: BSD-3-Clause
// Parses whatever bytes the fuzzer gives as a file of one format. The address and undefined-behaviour
// sanitizers watch; a mesh that comes out must be sound.
#include "LegacyVTKFile.h"
#include "ObjFile.h"
#include "OffFile.h"
#include "PlyFile.h"
#include "SegmentFile.h"
#include "StlFile.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace
{
using namespace marrow;

void Require(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}

void RequireIndices(const std::vector<int>& indices, std::size_t size)
{
  Require(std::all_of(indices.begin(), indices.end(),
    [size](int index) { return index >= 0 && static_cast<std::size_t>(index) < size; }));
}

void RequireStarts(const std::vector<std::size_t>& starts, std::size_t end)
{
  Require(
    std::is_sorted(starts.begin(), starts.end()) && starts.front() == 0 && starts.back() == end);
}

void RequireSizes(const std::vector<FileArray>& arrays, std::size_t size)
{
  for (const FileArray& array : arrays)
  {
    Require(array.NumberOfTuples() == size && array.AsDoubles().size() == size * array.Components);
  }
}

template <std::string (*Read)(std::string_view, std::string_view, FileMesh&, const Progress&)>
void Parse(std::string_view content)
{
  FileMesh mesh;
  if (!Read(content, "file", mesh, {}).empty())
  {
    return;
  }
  RequireIndices(mesh.Corners, mesh.Points.size());
  RequireStarts(mesh.FaceStarts, mesh.Corners.size());
  RequireSizes(mesh.PointArrays, mesh.Points.size());
  RequireSizes(mesh.FaceArrays, mesh.NumberOfFaces());
  for (const FileParts* parts : { &mesh.Groups, &mesh.Objects, &mesh.Materials })
  {
    Require(!parts->HasNames() || parts->PartOfFace().size() == mesh.NumberOfFaces());
    RequireIndices(parts->PartOfFace(), parts->NameOfPart().size());
  }
}

void ParseSegments(std::string_view content)
{
  std::vector<int> segments;
  ReadSegmentFile(content, "file", segments);
}

void ParseVTK(std::string_view content)
{
  LegacyVTKData data;
  if (!ReadLegacyVTKFile(content, "file", data).empty())
  {
    return;
  }
  for (const LegacyCells* cells :
    { &data.Vertices, &data.Lines, &data.Polygons, &data.Strips, &data.Cells })
  {
    RequireIndices(cells->Points, data.Points.size());
    RequireStarts(cells->Starts, cells->Points.size());
  }
  Require(data.CellTypes.size() == data.Cells.Size());
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  MARROW_FUZZ_PARSER(std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}
