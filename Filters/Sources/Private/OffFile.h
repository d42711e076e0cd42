// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_OffFile_h
#define marrow_OffFile_h

#include "Progress.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace marrow
{
/// What an OFF file holds. Arrays of attributes are empty where the file has none.
///
/// Parsed by hand and not with CGAL's stream support: that reads every file we tried, but tells
/// neither what is wrong with a bad one nor where, leaves out the colours of faces in plain OFF files
/// and refuses the header NCOFF.
struct OffFile
{
  using Color = std::array<unsigned char, 4>;

  std::vector<Eigen::Vector3d> Points;
  std::vector<Eigen::Vector3d> Normals;
  std::vector<Color> PointColors;
  std::vector<std::array<double, 2>> TextureCoordinates;
  std::vector<std::vector<int>> Faces; ///< of any number of corners
  std::vector<Color> FaceColors;       ///< if any face has one; grey where there is none
};

/// Reads an ASCII OFF file: any of the prefixes ST, C, N, 4; comments; one vertex or face a line, which
/// may go on in the next line. Returns one sentence that says what is wrong, or an empty one (also on
/// abort).
std::string ReadOffFile(const std::string& fileName, OffFile& file, const Progress& progress);
}

#endif
