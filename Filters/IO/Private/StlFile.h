// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_StlFile_h
#define marrow_StlFile_h

#include "FileMesh.h"
#include "Progress.h"

#include <string>
#include <string_view>

namespace marrow
{
/// Reads an STL file, text or binary: a face per facet, whose own normal is passed over. The format
/// knows no shared points, so corners of exactly equal coordinates become one. The solids of a text file
/// are its groups; the two bytes that a binary facet has to spare become the array `Attribute`, unless
/// all are 0. Returns one sentence that says what is wrong, or an empty one (also on abort).
std::string ReadStlFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress);
}

#endif
