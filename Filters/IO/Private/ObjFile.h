// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ObjFile_h
#define marrow_ObjFile_h

#include "FileMesh.h"
#include "Progress.h"

#include <string>
#include <string_view>

namespace marrow
{
/// Reads the points and faces of a Wavefront OBJ file, with the group, object and material of each face
/// and the colours that may follow a vertex. Normals, texture coordinates and all else are passed over.
/// Returns one sentence that says what is wrong, or an empty one (also on abort).
///
/// Parsed by hand and not with tinyobjloader: that leaves out faces of fewer than three corners, rounds
/// coordinates (its own conversion of numbers is not exact), says neither which face names a vertex
/// that is not there nor in which line, and goes on with it.
std::string ReadObjFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress);
}

#endif
