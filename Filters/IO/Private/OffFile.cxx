// SPDX-License-Identifier: BSD-3-Clause
#include "OffFile.h"

#include "TextReader.h"

#include <algorithm>

namespace marrow
{
namespace
{
class OffParser
{
public:
  OffParser(
    std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
    : Content(content)
    , Name(fileName)
    , Result(mesh)
    , Watcher(progress)
    , Text(content)
  {
  }

  std::string Parse()
  {
    std::string error = this->ReadHeader();
    if (!error.empty())
    {
      return error;
    }
    if (this->IsBinary)
    {
      return ReadBinaryOff(this->Content, this->Text.BytesRead(), this->Name, this->Format,
        this->Result, this->Watcher);
    }
    error = this->ReadCounts();
    if (error.empty())
    {
      error = this->ReadVertices();
    }
    if (error.empty() && !this->Aborted)
    {
      error = this->ReadFaces();
    }
    this->Attributes.MoveTo(this->Result);
    return error;
  }

private:
  std::string Error(const std::string& what) const { return NotValid(this->Name, "OFF", what); }
  std::string ErrorHere(const std::string& what) const
  {
    return this->Error("line " + std::to_string(this->Text.LineNumber()) + " " + what);
  }

  std::string ReadHeader()
  {
    if (!this->Text.NextLine())
    {
      return this->Error("it is empty");
    }
    this->Record = this->Text.Words();
    const std::string_view keyword = this->Record.front();
    const std::size_t at = keyword.find("OFF");
    const bool isKnown = at != std::string_view::npos &&
      keyword.substr(0, at).find_first_not_of("STCN4n") == std::string_view::npos;
    if (!isKnown)
    {
      return this->Error("it begins with " + Quoted(keyword) + " instead of OFF");
    }
    const std::string_view prefix = keyword.substr(0, at);
    auto has = [prefix](const char* letters)
    { return prefix.find(letters) != std::string_view::npos; };
    if (has("n"))
    {
      return "\"" + std::string(this->Name) +
        "\" is an n-dimensional OFF file, which is not supported: write it in three dimensions.";
    }
    this->Format = { has("ST"), has("C"), has("N"), has("4") };
    this->IsBinary = this->Record.size() > 1 && this->Record[1] == "BINARY";

    // The numbers may follow on the same line, even without a blank.
    this->Record.erase(this->Record.begin());
    if (keyword.size() > at + 3)
    {
      this->Record.insert(this->Record.begin(), keyword.substr(at + 3));
    }
    return {};
  }

  std::string ReadCounts()
  {
    if (this->Record.empty())
    {
      if (!this->Text.NextLine())
      {
        return this->Error("it ends after the header");
      }
      this->Record = this->Text.Words();
    }
    if (this->Record.size() < 2 || !ToNumber(this->Record[0], this->NumberOfVertices) ||
      !ToNumber(this->Record[1], this->NumberOfFaces) || this->NumberOfVertices < 0 ||
      this->NumberOfFaces < 0)
    {
      return this->ErrorHere(
        "should hold the numbers of vertices and faces but begins with " + Quoted(this->Record[0]));
    }
    return {};
  }

  /// The words of the next record, which has at least `count` of them, over as many lines as it
  /// takes; false at the end of the file.
  bool NextRecord(std::size_t count)
  {
    if (!this->Text.NextLine())
    {
      return false;
    }
    this->Record = this->Text.Words();
    return this->Extend(count);
  }
  bool Extend(std::size_t count)
  {
    while (this->Record.size() < count)
    {
      if (!this->Text.NextLine())
      {
        return false;
      }
      this->Record.insert(this->Record.end(), this->Text.Words().begin(), this->Text.Words().end());
    }
    return true;
  }

  /// Looks now and then whether to go on.
  bool GoesOn(int i)
  {
    constexpr int Interval = 1 << 14;
    this->Aborted =
      this->Aborted || (i % Interval == 0 && !Report(this->Watcher, this->Text.FractionRead()));
    return !this->Aborted;
  }

  std::string ReadVertices()
  {
    const OffHeader& format = this->Format;
    const std::size_t withoutColor = format.NumbersWithoutColor();
    const std::size_t beforeColor = format.NumbersBeforeColor();
    // A file too short for what it promises must not make us allocate that.
    this->Result.Points.reserve(
      std::min<std::size_t>(this->NumberOfVertices, this->Text.Size() / 6 + 1));
    std::vector<double> values;
    for (int i = 0; i < this->NumberOfVertices && this->GoesOn(i); ++i)
    {
      if (!this->NextRecord(withoutColor + (format.HasColors ? 3 : 0)))
      {
        return this->Error("it ends after " + std::to_string(i) + " of " +
          std::to_string(this->NumberOfVertices) + " vertices");
      }
      // Three components of colour, or four where the line has a word for it.
      const std::size_t color =
        !format.HasColors ? 0 : (this->Record.size() > withoutColor + 3 ? 4 : 3);
      values.clear();
      for (std::size_t k = 0; k < withoutColor + color; ++k)
      {
        double value = 0.0;
        if (!ToNumber(this->Record[k], value))
        {
          return this->ErrorHere("has " + Quoted(this->Record[k]) + " where vertex " +
            std::to_string(i) + " needs a number");
        }
        if (k < beforeColor || k >= beforeColor + color)
        {
          values.push_back(value);
        }
      }
      const double weight = format.IsHomogeneous ? values[3] : 1.0;
      if (weight == 0.0)
      {
        return this->ErrorHere("puts vertex " + std::to_string(i) + " at infinity");
      }
      this->Result.Points.push_back(Eigen::Vector3d(values[0], values[1], values[2]) / weight);
      this->Attributes.AddVertex(format, values.data(), this->ColorOf(beforeColor, color));
    }
    return {};
  }

  std::string ReadFaces()
  {
    this->Result.FaceStarts.reserve(
      std::min<std::size_t>(this->NumberOfFaces, this->Text.Size() / 2) + 1);
    for (int i = 0; i < this->NumberOfFaces && this->GoesOn(i); ++i)
    {
      const std::string truncated = "it ends after " + std::to_string(i) + " of " +
        std::to_string(this->NumberOfFaces) + " faces";
      if (!this->NextRecord(1))
      {
        return this->Error(truncated);
      }
      int corners = 0;
      if (!ToNumber(this->Record[0], corners) || corners < 0)
      {
        return this->ErrorHere("has " + Quoted(this->Record[0]) +
          " where the number of corners of face " + std::to_string(i) + " should be");
      }
      if (static_cast<std::size_t>(corners) > this->Text.Size() || !this->Extend(corners + 1))
      {
        return this->Error(truncated);
      }
      for (int k = 0; k < corners; ++k)
      {
        int corner = 0;
        if (!ToNumber(this->Record[k + 1], corner))
        {
          return this->ErrorHere("has " + Quoted(this->Record[k + 1]) + " where face " +
            std::to_string(i) + " needs the number of a vertex");
        }
        if (corner < 0 || corner >= this->NumberOfVertices)
        {
          return this->ErrorHere("makes face " + std::to_string(i) + " use vertex " +
            std::to_string(corner) + ", but the " + std::to_string(this->NumberOfVertices) +
            " vertices are numbered from 0");
        }
        this->Result.Corners.push_back(corner);
      }
      this->Result.EndFace();

      const std::size_t color = this->Record.size() - corners - 1;
      if (color >= 3)
      {
        this->Attributes.SetFaceColor(
          i, this->ColorOf(corners + 1, std::min<std::size_t>(color, 4)));
      }
    }
    return {};
  }

  /// Integers up to 255, or fractions of 1 if any component is written with a point.
  FileColor ColorOf(std::size_t first, std::size_t components) const
  {
    FileColor color{ 0, 0, 0, 255 };
    bool isFraction = false;
    for (std::size_t k = first; k < first + components; ++k)
    {
      isFraction |= this->Record[k].find('.') != std::string_view::npos;
    }
    for (std::size_t k = 0; k < components; ++k)
    {
      double value = 0.0;
      if (ToNumber(this->Record[first + k], value))
      {
        color[k] = ColorComponent(isFraction ? 255.0 * value : value);
      }
    }
    return color;
  }

  std::string_view Content;
  std::string_view Name;
  FileMesh& Result;
  const Progress& Watcher;
  TextReader Text;
  OffHeader Format;
  OffAttributes Attributes;
  bool IsBinary = false;
  int NumberOfVertices = 0;
  int NumberOfFaces = 0;
  std::vector<std::string_view> Record;
  bool Aborted = false;
};
}

std::string ReadOffFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
{
  mesh = FileMesh();
  return OffParser(content, fileName, mesh, progress).Parse();
}

void OffAttributes::AddVertex(
  const OffHeader& header, const double* numbers, const FileColor& color)
{
  const double* next = numbers + header.Coordinates();
  if (header.HasNormals)
  {
    this->Normals.insert(this->Normals.end(), next, next + 3);
    next += 3;
  }
  if (header.HasColors)
  {
    this->PointColors.push_back(color);
  }
  if (header.HasTextureCoordinates)
  {
    this->TextureCoordinates.insert(this->TextureCoordinates.end(), next, next + 2);
  }
}

void OffAttributes::SetFaceColor(std::size_t face, const FileColor& color)
{
  this->FaceColors.resize(face, NoFaceColor);
  this->FaceColors.push_back(color);
}

void OffAttributes::MoveTo(FileMesh& mesh)
{
  if (!this->Normals.empty())
  {
    mesh.PointArrays.push_back({ NormalsName, std::move(this->Normals), 3 });
  }
  if (!this->PointColors.empty())
  {
    mesh.PointArrays.push_back(ColorArray(this->PointColors));
  }
  if (!this->TextureCoordinates.empty())
  {
    mesh.PointArrays.push_back({ TextureCoordinatesName, std::move(this->TextureCoordinates), 2 });
  }
  if (!this->FaceColors.empty())
  {
    this->FaceColors.resize(mesh.NumberOfFaces(), NoFaceColor);
    mesh.FaceArrays.push_back(ColorArray(this->FaceColors));
  }
}
}
