// SPDX-License-Identifier: BSD-3-Clause
#include "ByteReader.h"
#include "OffFile.h"

#include <algorithm>
#include <cstdint>

namespace marrow
{
namespace
{
/// Big-endian integers and floats of four bytes: the three counts, the vertices, and each face as its
/// number of corners, these, its number of colour components, and these.
class BinaryOffParser
{
public:
  BinaryOffParser(std::string_view content, std::size_t begin, std::string_view fileName,
    const OffHeader& header, FileMesh& mesh, const Progress& progress)
    : Bytes(content, begin, true)
    , Name(fileName)
    , Format(header)
    , Result(mesh)
    , Watcher(progress)
  {
  }

  std::string Parse()
  {
    std::int32_t vertices = 0;
    std::int32_t faces = 0;
    std::int32_t edges = 0;
    if (!this->Bytes.Next(vertices) || !this->Bytes.Next(faces) || !this->Bytes.Next(edges))
    {
      return this->Error("it ends after the header");
    }
    if (vertices < 0 || faces < 0)
    {
      return this->Error("it promises " + std::to_string(vertices) + " vertices and " +
        std::to_string(faces) + " faces");
    }
    std::string error = this->ReadVertices(vertices);
    if (error.empty() && !this->Aborted)
    {
      error = this->ReadFaces(faces);
    }
    this->Attributes.MoveTo(this->Result);
    return error;
  }

private:
  std::string Error(const std::string& what) const { return NotValid(this->Name, "OFF", what); }
  std::string ErrorHere(const std::string& what) const
  {
    return this->Error("byte " + std::to_string(this->Bytes.Position()) + " " + what);
  }
  bool GoesOn(int i)
  {
    constexpr int Interval = 1 << 14;
    this->Aborted =
      this->Aborted || (i % Interval == 0 && !Report(this->Watcher, this->Bytes.FractionRead()));
    return !this->Aborted;
  }

  bool NextFloats(std::size_t count, std::vector<double>& values)
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      float value = 0.0F;
      if (!this->Bytes.Next(value))
      {
        return false;
      }
      values.push_back(value);
    }
    return true;
  }

  /// Components from 0 to 1.
  static FileColor ColorOf(const std::vector<double>& components)
  {
    FileColor color{ 0, 0, 0, 255 };
    for (std::size_t k = 0; k < std::min(color.size(), components.size()); ++k)
    {
      color[k] = ColorComponent(255.0 * components[k]);
    }
    return color;
  }

  std::string ReadVertices(int count)
  {
    const OffHeader& format = this->Format;
    this->Result.Points.reserve(std::min<std::size_t>(count, this->Bytes.Left() / 12));
    std::vector<double> values;
    std::vector<double> color;
    for (int i = 0; i < count && this->GoesOn(i); ++i)
    {
      values.clear();
      color.clear();
      const std::size_t beforeColor = format.NumbersBeforeColor();
      if (!this->NextFloats(beforeColor, values) ||
        !this->NextFloats(format.HasColors ? 4 : 0, color) ||
        !this->NextFloats(format.NumbersWithoutColor() - beforeColor, values))
      {
        return this->Error(
          "it ends after " + std::to_string(i) + " of " + std::to_string(count) + " vertices");
      }
      const double weight = format.IsHomogeneous ? values[3] : 1.0;
      if (weight == 0.0)
      {
        return this->ErrorHere("puts vertex " + std::to_string(i) + " at infinity");
      }
      this->Result.Points.push_back(Eigen::Vector3d(values[0], values[1], values[2]) / weight);
      this->Attributes.AddVertex(format, values.data(), ColorOf(color));
    }
    return {};
  }

  std::string ReadFaces(int count)
  {
    const auto numberOfVertices = static_cast<int>(this->Result.Points.size());
    this->Result.FaceStarts.reserve(std::min<std::size_t>(count, this->Bytes.Left() / 8) + 1);
    std::vector<double> color;
    for (int i = 0; i < count && this->GoesOn(i); ++i)
    {
      const std::string truncated =
        "it ends after " + std::to_string(i) + " of " + std::to_string(count) + " faces";
      std::int32_t corners = 0;
      if (!this->Bytes.Next(corners))
      {
        return this->Error(truncated);
      }
      if (corners < 0)
      {
        return this->ErrorHere(
          "gives face " + std::to_string(i) + " " + std::to_string(corners) + " corners");
      }
      for (std::int32_t k = 0; k < corners; ++k)
      {
        std::int32_t corner = 0;
        if (!this->Bytes.Next(corner))
        {
          return this->Error(truncated);
        }
        if (corner < 0 || corner >= numberOfVertices)
        {
          return this->ErrorHere("makes face " + std::to_string(i) + " use vertex " +
            std::to_string(corner) + ", but the " + std::to_string(numberOfVertices) +
            " vertices are numbered from 0");
        }
        this->Result.Corners.push_back(corner);
      }
      this->Result.EndFace();
      std::int32_t components = 0;
      color.clear();
      if (!this->Bytes.Next(components) || components < 0 ||
        static_cast<std::size_t>(components) > this->Bytes.Left() / 4 ||
        !this->NextFloats(components, color))
      {
        return this->Error(truncated);
      }
      if (components >= 3)
      {
        this->Attributes.SetFaceColor(i, ColorOf(color));
      }
    }
    return {};
  }

  ByteReader Bytes;
  std::string_view Name;
  const OffHeader& Format;
  FileMesh& Result;
  const Progress& Watcher;
  OffAttributes Attributes;
  bool Aborted = false;
};
}

std::string ReadBinaryOff(std::string_view content, std::size_t begin, std::string_view fileName,
  const OffHeader& header, FileMesh& mesh, const Progress& progress)
{
  return BinaryOffParser(content, begin, fileName, header, mesh, progress).Parse();
}
}
