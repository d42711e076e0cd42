// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_OffFile_h
#define marrow_OffFile_h

#include "FileMesh.h"
#include "Progress.h"

#include <string>
#include <string_view>

namespace marrow
{
/// What the header of an OFF file promises of every vertex.
struct OffHeader
{
  bool HasTextureCoordinates = false;
  bool HasColors = false;
  bool HasNormals = false;
  bool IsHomogeneous = false;

  std::size_t Coordinates() const { return this->IsHomogeneous ? 4 : 3; }
  std::size_t NumbersBeforeColor() const
  {
    return this->Coordinates() + (this->HasNormals ? 3 : 0);
  }
  std::size_t NumbersWithoutColor() const
  {
    return this->NumbersBeforeColor() + (this->HasTextureCoordinates ? 2 : 0);
  }
};

/// Reads an OFF file, text or binary, with any of the prefixes ST, C, N, 4. In text: comments; one
/// vertex or face a line, which may go on in the next line. Returns one sentence that says what is
/// wrong, or an empty one (also on abort).
///
/// Parsed by hand and not with CGAL's stream support: that reads every file we tried, but tells
/// neither what is wrong with a bad one nor where, leaves out the colours of faces in plain OFF files
/// and refuses the header NCOFF.
std::string ReadOffFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress);

/// The binary part of the same, behind the line of the header.
std::string ReadBinaryOff(std::string_view content, std::size_t begin, std::string_view fileName,
  const OffHeader& header, FileMesh& mesh, const Progress& progress);

/// The colour of faces for which the file has none.
inline constexpr FileColor NoFaceColor{ 170, 170, 170, 255 };

/// Collects what an OFF file says of its vertices and faces beside coordinates and corners.
class OffAttributes
{
public:
  /// The numbers of a vertex as they are in the file.
  void AddVertex(const OffHeader& header, const double* numbers, const FileColor& color);
  /// The colour of a face; must be told for those only that have one.
  void SetFaceColor(std::size_t face, const FileColor& color);
  /// Puts the arrays on the mesh, whose faces are complete.
  void MoveTo(FileMesh& mesh);

private:
  std::vector<double> Normals;
  std::vector<double> TextureCoordinates;
  std::vector<FileColor> PointColors;
  std::vector<FileColor> FaceColors;
};
}

#endif
