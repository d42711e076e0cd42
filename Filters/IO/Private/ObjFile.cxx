// SPDX-License-Identifier: BSD-3-Clause
#include "ObjFile.h"

#include "TextReader.h"

#include <algorithm>
#include <limits>

namespace marrow
{
namespace
{
class ObjParser
{
public:
  ObjParser(
    std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
    : Name(fileName)
    , Result(mesh)
    , Watcher(progress)
    , Text(content, TextReader::Style::WaveFront)
  {
  }

  std::string Parse()
  {
    constexpr std::size_t Interval = 1 << 14;
    std::string error;
    for (std::size_t line = 0; error.empty() && this->Text.NextLine(); ++line)
    {
      if (line % Interval == 0 && !Report(this->Watcher, this->Text.FractionRead()))
      {
        return {};
      }
      error = this->ReadStatement();
    }
    if (error.empty())
    {
      error = this->CheckForwardReferences();
    }
    if (!this->Colors.empty())
    {
      constexpr FileColor White{ 255, 255, 255, 255 };
      this->Colors.resize(this->Result.Points.size(), White);
      this->Result.PointArrays.push_back(ColorArray(this->Colors));
    }
    return error;
  }

private:
  std::string ErrorIn(int line, const std::string& what) const
  {
    return NotValid(this->Name, "OBJ", "line " + std::to_string(line) + " " + what);
  }
  std::string ErrorHere(const std::string& what) const
  {
    return this->ErrorIn(this->Text.LineNumber(), what);
  }

  std::string ReadStatement()
  {
    const std::string_view keyword = this->Text.Words().front();
    if (keyword == "v")
    {
      return this->ReadVertex();
    }
    if (keyword == "f" || keyword == "fo") // as the format's first version had it
    {
      return this->ReadFace();
    }
    if (keyword == "g")
    {
      this->Result.Groups.Begin(this->NameInLine());
    }
    else if (keyword == "o")
    {
      this->Result.Objects.Begin(this->NameInLine());
    }
    else if (keyword == "usemtl")
    {
      this->Result.Materials.Begin(this->NameInLine());
    }
    return {};
  }

  std::string NameInLine() const
  {
    std::string name;
    for (std::size_t k = 1; k < this->Text.Words().size(); ++k)
    {
      name += (k > 1 ? " " : "") + std::string(this->Text.Words()[k]);
    }
    return name;
  }

  std::string ReadVertex()
  {
    const std::vector<std::string_view>& words = this->Text.Words();
    const std::size_t index = this->Result.Points.size();
    if (words.size() < 4)
    {
      return this->ErrorHere(
        "has fewer than three coordinates for vertex " + std::to_string(index + 1));
    }
    if (index >= static_cast<std::size_t>(std::numeric_limits<int>::max()))
    {
      return this->ErrorHere("is one vertex more than can be numbered");
    }
    double numbers[6];
    const std::size_t count = words.size() >= 7 ? 6 : 3;
    for (std::size_t k = 0; k < count; ++k)
    {
      if (!ToNumber(words[k + 1], numbers[k]))
      {
        return this->ErrorHere("has " + Quoted(words[k + 1]) + " where vertex " +
          std::to_string(index + 1) + " needs a number");
      }
    }
    this->Result.Points.emplace_back(numbers[0], numbers[1], numbers[2]);
    if (count == 6)
    {
      this->AddColor(index, numbers + 3);
    }
    return {};
  }

  /// Fractions of 1, as programs write them that put colours on vertices.
  void AddColor(std::size_t point, const double* rgb)
  {
    constexpr FileColor White{ 255, 255, 255, 255 };
    this->Colors.resize(point, White);
    this->Colors.push_back({ ColorComponent(255.0 * rgb[0]), ColorComponent(255.0 * rgb[1]),
      ColorComponent(255.0 * rgb[2]), 255 });
  }

  std::string ReadFace()
  {
    const std::vector<std::string_view>& words = this->Text.Words();
    const auto numberOfPoints = static_cast<std::int64_t>(this->Result.Points.size());
    for (std::size_t k = 1; k < words.size(); ++k)
    {
      // The index to the texture coordinates and that to the normals may follow.
      const std::string_view word = words[k].substr(0, words[k].find('/'));
      std::int64_t number = 0;
      if (!ToNumber(word, number))
      {
        return this->ErrorHere(
          "has " + Quoted(words[k]) + " where a face needs the number of a vertex");
      }
      const std::int64_t index = number < 0 ? numberOfPoints + number : number - 1;
      if (number == 0 || index < 0 || index >= std::numeric_limits<int>::max())
      {
        return this->MissingVertex(this->Text.LineNumber(), number, numberOfPoints);
      }
      if (index >= numberOfPoints)
      {
        this->ForwardReferences.push_back({ index, this->Text.LineNumber() });
      }
      this->Result.Corners.push_back(static_cast<int>(index));
    }
    this->Result.EndFace();
    this->Result.Groups.AddFace();
    this->Result.Objects.AddFace();
    this->Result.Materials.AddFace();
    return {};
  }

  std::string MissingVertex(int line, std::int64_t number, std::int64_t numberOfPoints) const
  {
    return this->ErrorIn(line,
      "makes a face use vertex " + std::to_string(number) + ", but the " +
        std::to_string(numberOfPoints) + " vertices are numbered from 1");
  }

  /// A face may stand before its vertices.
  std::string CheckForwardReferences() const
  {
    const auto numberOfPoints = static_cast<std::int64_t>(this->Result.Points.size());
    const auto missing =
      std::find_if(this->ForwardReferences.begin(), this->ForwardReferences.end(),
        [numberOfPoints](const ForwardReference& reference)
        { return reference.Index >= numberOfPoints; });
    return missing == this->ForwardReferences.end()
      ? std::string()
      : this->MissingVertex(missing->Line, missing->Index + 1, numberOfPoints);
  }

  struct ForwardReference
  {
    std::int64_t Index;
    int Line;
  };

  std::string_view Name;
  FileMesh& Result;
  const Progress& Watcher;
  TextReader Text;
  std::vector<FileColor> Colors;
  std::vector<ForwardReference> ForwardReferences;
};
}

std::string ReadObjFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
{
  mesh = FileMesh();
  return ObjParser(content, fileName, mesh, progress).Parse();
}
}
