// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PlyFile_h
#define marrow_PlyFile_h

#include "FileMesh.h"
#include "Progress.h"

#include <string>
#include <string_view>

namespace marrow
{
/// Reads a PLY file: text, or binary of either byte order; properties of any type; further elements are
/// passed over. Points are the element `vertex`, faces the list `vertex_indices` (or `vertex_index`, or
/// else the first list) of the element `face`, or where there is no such element
/// the triangles of `tristrips`. The other
/// properties of vertices and faces become arrays in their own types, lists excepted. Returns one
/// sentence that says what is wrong, or an empty one (also on abort).
std::string ReadPlyFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress);
}

#endif
