// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LegacyVTKFile_h
#define marrow_LegacyVTKFile_h

#include "FileMesh.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace marrow
{
/// The points of cells, one after the other.
struct LegacyCells
{
  std::vector<int> Points;
  std::vector<std::size_t> Starts = { 0 }; ///< where those of each cell begin, and the end

  std::size_t Size() const { return this->Starts.size() - 1; }
};

/// What a file of VTK's older kind holds.
struct LegacyVTKData
{
  bool IsGrid = false; ///< an unstructured grid, else polygonal data
  std::vector<Eigen::Vector3d> Points;
  LegacyCells Vertices;
  LegacyCells Lines;
  LegacyCells Polygons;
  LegacyCells Strips;
  LegacyCells Cells;          ///< of the grid
  std::vector<int> CellTypes; ///< as many
  std::vector<FileArray> PointArrays;
  std::vector<FileArray> CellArrays;
  std::vector<FileArray> FieldArrays;
  std::vector<std::pair<std::string, std::vector<std::string>>> FieldStrings;
};

/// Reads a file of VTK's older kind, text or binary, of the versions to 5.1: polygonal data or an
/// unstructured grid. Arrays of strings are kept only as field data of the whole, look-up tables not at
/// all. Returns one sentence that says what is wrong, or an empty one.
///
/// Parsed by hand, as VTK's own reader (9.1) crashes on files that are cut or hold something else.
std::string ReadLegacyVTKFile(
  std::string_view content, std::string_view fileName, LegacyVTKData& data);
}

#endif
