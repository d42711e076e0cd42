// SPDX-License-Identifier: BSD-3-Clause
#include "OffFile.h"

#include "TextFile.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// What a header promises.
struct Header
{
  bool HasTextureCoordinates = false;
  bool HasColors = false;
  bool HasNormals = false;
  bool IsHomogeneous = false;
};

class OffParser
{
public:
  OffParser(const std::string& fileName, OffFile& file, const Progress& progress)
    : Name(fileName)
    , Result(file)
    , Watcher(progress)
  {
  }

  std::string Parse()
  {
    this->Result = OffFile();
    std::string error = this->Text.Open(this->Name);
    if (error.empty())
    {
      error = this->ReadHeader();
    }
    if (error.empty())
    {
      error = this->ReadVertices();
    }
    if (error.empty() && !this->Aborted)
    {
      error = this->ReadFaces();
    }
    return error;
  }

private:
  std::string Error(const std::string& what) const
  {
    return "\"" + this->Name + "\" is not a valid OFF file: " + what + ".";
  }
  std::string ErrorHere(const std::string& what) const
  {
    return this->Error("line " + std::to_string(this->Text.LineNumber()) + " " + what);
  }
  static std::string Quoted(std::string_view word)
  {
    constexpr std::size_t Longest = 20;
    const std::string text(word.substr(0, Longest));
    const bool isText =
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= 32 && c < 127; });
    return isText ? "\"" + text + (word.size() > Longest ? "...\"" : "\"")
                  : std::string("bytes that are not text");
  }

  std::string ReadHeader()
  {
    if (!this->Text.NextLine())
    {
      return this->Error("it is empty");
    }
    std::vector<std::string_view> words = this->Text.Words();
    std::string_view keyword = words.front();
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
    if (has("n") || (words.size() > 1 && words[1] == "BINARY"))
    {
      return "\"" + this->Name + "\" is " + (has("n") ? "an n-dimensional" : "a binary") +
        " OFF file, which is not supported: write it as plain three-dimensional text.";
    }
    this->Format = { has("ST"), has("C"), has("N"), has("4") };

    // The numbers may follow on the same line, even without a blank.
    words.erase(words.begin());
    if (keyword.size() > at + 3)
    {
      words.insert(words.begin(), keyword.substr(at + 3));
    }
    if (words.empty())
    {
      if (!this->Text.NextLine())
      {
        return this->Error("it ends after the header");
      }
      words = this->Text.Words();
    }
    if (words.size() < 2 || !ToNumber(words[0], this->NumberOfVertices) ||
      !ToNumber(words[1], this->NumberOfFaces) || this->NumberOfVertices < 0 ||
      this->NumberOfFaces < 0)
    {
      return this->ErrorHere(
        "should hold the numbers of vertices and faces but begins with " + Quoted(words[0]));
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
    const Header& format = this->Format;
    const std::size_t coordinates = format.IsHomogeneous ? 4 : 3;
    const std::size_t normal = format.HasNormals ? 3 : 0;
    const std::size_t texture = format.HasTextureCoordinates ? 2 : 0;
    const std::size_t withoutColor = coordinates + normal + texture;
    // A file too short for what it promises must not make us allocate that.
    this->Result.Points.reserve(
      std::min<std::size_t>(this->NumberOfVertices, this->Text.Size() / 6 + 1));
    std::vector<double> values;
    for (int i = 0; i < this->NumberOfVertices && this->GoesOn(i); ++i)
    {
      if (!this->NextRecord(withoutColor + (format.HasColors ? 3 : 0)))
      {
        return this->Error("it promises " + std::to_string(this->NumberOfVertices) +
          " vertices but ends after " + std::to_string(i));
      }
      // Three components of colour, or four where the line has a word for it.
      const std::size_t color =
        !format.HasColors ? 0 : (this->Record.size() > withoutColor + 3 ? 4 : 3);
      values.resize(withoutColor + color);
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        if (!ToNumber(this->Record[k], values[k]))
        {
          return this->ErrorHere("has " + Quoted(this->Record[k]) + " where vertex " +
            std::to_string(i) + " needs a number");
        }
      }
      const double weight = format.IsHomogeneous ? values[3] : 1.0;
      if (weight == 0.0)
      {
        return this->ErrorHere("puts vertex " + std::to_string(i) + " at infinity");
      }
      this->Result.Points.push_back(Eigen::Vector3d(values[0], values[1], values[2]) / weight);
      const double* next = values.data() + coordinates;
      if (format.HasNormals)
      {
        this->Result.Normals.push_back({ next[0], next[1], next[2] });
        next += 3;
      }
      if (format.HasColors)
      {
        this->Result.PointColors.push_back(this->ColorOf(coordinates + normal, color));
        next += color;
      }
      if (format.HasTextureCoordinates)
      {
        this->Result.TextureCoordinates.push_back({ next[0], next[1] });
      }
    }
    return {};
  }

  std::string ReadFaces()
  {
    this->Result.Faces.reserve(
      std::min<std::size_t>(this->NumberOfFaces, this->Text.Size() / 2 + 1));
    for (int i = 0; i < this->NumberOfFaces && this->GoesOn(i); ++i)
    {
      const std::string truncated = "it promises " + std::to_string(this->NumberOfFaces) +
        " faces but ends after " + std::to_string(i);
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
      std::vector<int> face(corners);
      for (int k = 0; k < corners; ++k)
      {
        if (!ToNumber(this->Record[k + 1], face[k]))
        {
          return this->ErrorHere("has " + Quoted(this->Record[k + 1]) + " where face " +
            std::to_string(i) + " needs the number of a vertex");
        }
        if (face[k] < 0 || face[k] >= this->NumberOfVertices)
        {
          return this->ErrorHere("makes face " + std::to_string(i) + " use vertex " +
            std::to_string(face[k]) + ", but the " + std::to_string(this->NumberOfVertices) +
            " vertices are numbered from 0");
        }
      }
      this->Result.Faces.push_back(std::move(face));

      const std::size_t color = this->Record.size() - corners - 1;
      if (color >= 3)
      {
        constexpr OffFile::Color Grey{ 170, 170, 170, 255 };
        this->Result.FaceColors.resize(i, Grey);
        this->Result.FaceColors.push_back(
          this->ColorOf(corners + 1, std::min<std::size_t>(color, 4)));
      }
      else if (!this->Result.FaceColors.empty())
      {
        this->Result.FaceColors.push_back({ 170, 170, 170, 255 });
      }
    }
    return {};
  }

  /// Integers up to 255, or fractions of 1 if any component is written with a point.
  OffFile::Color ColorOf(std::size_t first, std::size_t components) const
  {
    OffFile::Color color{ 0, 0, 0, 255 };
    bool isFraction = false;
    for (std::size_t k = first; k < first + components; ++k)
    {
      isFraction |= this->Record[k].find('.') != std::string_view::npos;
    }
    for (std::size_t k = 0; k < components; ++k)
    {
      double value = 0.0;
      if (ToNumber(this->Record[first + k], value) && std::isfinite(value))
      {
        color[k] = static_cast<unsigned char>(
          std::lround(std::clamp(isFraction ? 255.0 * value : value, 0.0, 255.0)));
      }
    }
    return color;
  }

  const std::string& Name;
  OffFile& Result;
  const Progress& Watcher;
  TextFile Text;
  Header Format;
  int NumberOfVertices = 0;
  int NumberOfFaces = 0;
  std::vector<std::string_view> Record;
  bool Aborted = false;
};
}

std::string ReadOffFile(const std::string& fileName, OffFile& file, const Progress& progress)
{
  return OffParser(fileName, file, progress).Parse();
}
}
