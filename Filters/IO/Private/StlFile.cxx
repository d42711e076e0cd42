// SPDX-License-Identifier: BSD-3-Clause
#include "StlFile.h"

#include "ByteReader.h"
#include "PointMerging.h"
#include "TextReader.h"

#include <algorithm>
#include <cctype>
#include <limits>

namespace marrow
{
namespace
{
constexpr std::size_t SizeOfHeader = 80;
constexpr std::size_t SizeOfFacet = 50;
constexpr std::size_t Interval = 1 << 14;

bool IsKeyword(std::string_view word, std::string_view keyword)
{
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
    [](unsigned char a, char b) { return std::tolower(a) == b; });
}

/// The number of facets that the header of a binary file promises; false if it is too short for one.
bool BinaryCount(std::string_view content, std::uint32_t& count)
{
  return content.size() >= SizeOfHeader && ByteReader(content, SizeOfHeader, false).Next(count);
}

/// Both kinds may begin with "solid", so that a size that fits a binary file decides.
bool IsText(std::string_view content)
{
  std::uint32_t count = 0;
  if (BinaryCount(content, count) && content.size() == SizeOfHeader + 4 + count * SizeOfFacet)
  {
    return false;
  }
  TextReader text(content.substr(0, SizeOfHeader), TextReader::Style::Plain);
  return text.NextLine() && IsKeyword(text.Words().front(), "solid");
}

class StlText
{
public:
  StlText(
    std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
    : Text(content, TextReader::Style::Plain)
    , Name(fileName)
    , Result(mesh)
    , Watcher(progress)
  {
  }

  std::string Parse()
  {
    std::string error;
    for (std::size_t line = 0; error.empty() && this->Text.NextLine(); ++line)
    {
      if (line % Interval == 0 && !Report(this->Watcher, this->Text.FractionRead()))
      {
        return {};
      }
      error = this->ReadLine();
    }
    if (error.empty() && this->Result.Corners.size() > this->Result.FaceStarts.back())
    {
      error = this->Error("it ends within facet " + std::to_string(this->Result.NumberOfFaces()));
    }
    return error;
  }

private:
  std::string Error(const std::string& what) const { return NotValid(this->Name, "STL", what); }

  std::string ReadLine()
  {
    const std::vector<std::string_view>& words = this->Text.Words();
    for (std::size_t k = 0; k < words.size(); ++k)
    {
      // Whole facets may stand in one line.
      if (IsKeyword(words[k], "vertex"))
      {
        Eigen::Vector3d point;
        for (int axis = 0; axis < 3; ++axis)
        {
          ++k;
          if (k >= words.size() || !ToNumber(words[k], point[axis]))
          {
            return this->Error("line " + std::to_string(this->Text.LineNumber()) + " has " +
              (k < words.size() ? Quoted(words[k]) : std::string("nothing")) +
              " where a vertex needs a number");
          }
        }
        this->Result.Corners.push_back(static_cast<int>(this->Result.Points.size()));
        this->Result.Points.push_back(point);
      }
      else if (IsKeyword(words[k], "endfacet"))
      {
        this->Result.EndFace();
        this->Result.Groups.AddFace();
      }
      else if (IsKeyword(words[k], "solid"))
      {
        std::string name;
        for (++k; k < words.size(); ++k)
        {
          name += (name.empty() ? "" : " ") + std::string(words[k]);
        }
        this->Result.Groups.Begin(name);
      }
      else if (IsKeyword(words[k], "endsolid"))
      {
        return {};
      }
    }
    return {};
  }

  TextReader Text;
  std::string_view Name;
  FileMesh& Result;
  const Progress& Watcher;
};

std::string ReadBinary(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
{
  std::uint32_t count = 0;
  if (!BinaryCount(content, count))
  {
    return NotValid(fileName, "STL", "it neither begins with solid nor has a binary header");
  }
  constexpr std::uint32_t Most = std::numeric_limits<int>::max() / 3;
  ByteReader bytes(content, SizeOfHeader + 4, false);
  const std::size_t complete = bytes.Left() / SizeOfFacet;
  if (complete < count || count > Most)
  {
    return NotValid(fileName, "STL",
      count > Most
        ? "it promises more facets than can be numbered"
        : "it ends after " + std::to_string(complete) + " of " + std::to_string(count) + " facets");
  }
  mesh.Points.reserve(3 * static_cast<std::size_t>(count));
  mesh.Corners.reserve(3 * static_cast<std::size_t>(count));
  mesh.FaceStarts.reserve(static_cast<std::size_t>(count) + 1);
  std::vector<std::uint16_t> attributes;
  attributes.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    if (i % Interval == 0 && !Report(progress, bytes.FractionRead()))
    {
      return {};
    }
    // The normal, then the corners.
    float numbers[12] = {};
    for (float& number : numbers)
    {
      bytes.Next(number);
    }
    for (int corner = 1; corner < 4; ++corner)
    {
      const float* point = numbers + 3 * corner;
      mesh.Corners.push_back(static_cast<int>(mesh.Points.size()));
      mesh.Points.emplace_back(point[0], point[1], point[2]);
    }
    mesh.EndFace();
    attributes.push_back(0);
    bytes.Next(attributes.back());
  }
  if (std::any_of(
        attributes.begin(), attributes.end(), [](std::uint16_t value) { return value != 0; }))
  {
    mesh.FaceArrays.push_back({ "Attribute", std::move(attributes) });
  }
  return {};
}
}

std::string ReadStlFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
{
  mesh = FileMesh();
  std::string error = IsText(content) ? StlText(content, fileName, mesh, progress).Parse()
                                      : ReadBinary(content, fileName, mesh, progress);
  if (error.empty())
  {
    MergeEqualPoints(mesh);
  }
  return error;
}
}
