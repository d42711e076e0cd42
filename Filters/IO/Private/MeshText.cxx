// SPDX-License-Identifier: BSD-3-Clause
#include "MeshText.h"

#include "PartNumbers.h"
#include "SegmentColors.h"

#include <charconv>
#include <cstring>

namespace marrow
{
namespace
{
template <typename Number>
void Append(std::string& text, Number number)
{
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), number).ptr);
}

void AppendPoint(std::string& text, const Eigen::Vector3d& point)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    text += axis > 0 ? " " : "";
    Append(text, point[axis]);
  }
  text += '\n';
}

/// Little-endian, whatever the machine.
template <typename Number>
void AppendBytes(std::string& bytes, Number number)
{
  std::uint64_t bits = 0;
  if constexpr (sizeof(Number) == sizeof(std::uint64_t))
  {
    std::memcpy(&bits, &number, sizeof(Number));
  }
  else
  {
    bits = static_cast<std::uint32_t>(number);
  }
  for (std::size_t k = 0; k < sizeof(Number); ++k)
  {
    bytes += static_cast<char>(bits >> (8 * k) & 0xFFU);
  }
}
}

std::string OffFileContent(const FileMesh& mesh, const FileSegments& segments)
{
  const std::map<int, FileColor> colors = ColorsOfSegments(segments.Labels, segments.NameOfLabel);
  std::string text = "OFF\n";
  Append(text, mesh.Points.size());
  text += ' ';
  Append(text, mesh.NumberOfFaces());
  text += " 0\n";
  for (const Eigen::Vector3d& point : mesh.Points)
  {
    AppendPoint(text, point);
  }
  for (std::size_t face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    Append(text, mesh.FaceStarts[face + 1] - mesh.FaceStarts[face]);
    for (std::size_t k = mesh.FaceStarts[face]; k < mesh.FaceStarts[face + 1]; ++k)
    {
      text += ' ';
      Append(text, mesh.Corners[k]);
    }
    if (!segments.Labels.empty())
    {
      const FileColor& color = colors.at(segments.Labels[face]);
      for (std::size_t k = 0; k < (color[3] == 255 ? 3 : 4); ++k)
      {
        text += ' ';
        Append(text, static_cast<int>(color[k]));
      }
    }
    text += '\n';
  }
  return text;
}

std::string ObjFileContent(const FileMesh& mesh, const FileSegments& segments)
{
  std::string text;
  for (const Eigen::Vector3d& point : mesh.Points)
  {
    text += "v ";
    AppendPoint(text, point);
  }
  for (std::size_t face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    if (!segments.Labels.empty() &&
      (face == 0 || segments.Labels[face] != segments.Labels[face - 1]))
    {
      const int label = segments.Labels[face];
      const bool isNamed = label >= 0 && label < static_cast<int>(segments.NameOfLabel.size()) &&
        !segments.NameOfLabel[label].empty();
      text += "g " + (isNamed ? segments.NameOfLabel[label] : NameOfSegment(label)) + "\n";
    }
    text += 'f';
    for (std::size_t k = mesh.FaceStarts[face]; k < mesh.FaceStarts[face + 1]; ++k)
    {
      text += ' ';
      Append(text, mesh.Corners[k] + 1);
    }
    text += '\n';
  }
  return text;
}

std::string PlyFileContent(const FileMesh& mesh, const FileSegments& segments)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
    std::to_string(mesh.Points.size()) +
    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
    std::to_string(mesh.NumberOfFaces()) + "\nproperty list int int vertex_indices\n" +
    (segments.Labels.empty() ? "" : "property int SegmentId\n") + "end_header\n";
  for (const Eigen::Vector3d& point : mesh.Points)
  {
    for (const double coordinate : point)
    {
      AppendBytes(bytes, coordinate);
    }
  }
  for (std::size_t face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    AppendBytes(bytes, static_cast<int>(mesh.FaceStarts[face + 1] - mesh.FaceStarts[face]));
    for (std::size_t k = mesh.FaceStarts[face]; k < mesh.FaceStarts[face + 1]; ++k)
    {
      AppendBytes(bytes, mesh.Corners[k]);
    }
    if (!segments.Labels.empty())
    {
      AppendBytes(bytes, segments.Labels[face]);
    }
  }
  return bytes;
}
}
