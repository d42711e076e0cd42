// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshText_h
#define marrow_MeshText_h

#include "FileMesh.h"

#include <string>
#include <vector>

namespace marrow
{
/// The segments that go to a file with a mesh.
struct FileSegments
{
  std::vector<int> Labels; ///< per face; empty if the mesh has none
  std::vector<std::string>
    NameOfLabel; ///< may be shorter than the labels reach, or hold empty names
};

// The contents of files. Coordinates are written such that reading gives the same doubles.

/// Text; the segments as face colours.
std::string OffFileContent(const FileMesh& mesh, const FileSegments& segments);

/// Text; the segments as groups, begun anew wherever the segment changes, as faces keep their order.
std::string ObjFileContent(const FileMesh& mesh, const FileSegments& segments);

/// Binary, little-endian; the segments as the face property SegmentId.
std::string PlyFileContent(const FileMesh& mesh, const FileSegments& segments);
}

#endif
