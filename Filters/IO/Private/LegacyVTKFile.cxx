// SPDX-License-Identifier: BSD-3-Clause
#include "LegacyVTKFile.h"

#include "LegacyVTKSource.h"
#include "TextReader.h"

#include <algorithm>
#include <limits>

namespace marrow
{
namespace
{
using Words = std::vector<std::string_view>;

class LegacyVTKParser
{
public:
  LegacyVTKParser(std::string_view content, std::string_view fileName, LegacyVTKData& data)
    : Source(content)
    , Content(content)
    , Name(fileName)
    , Result(data)
  {
  }

  std::string Parse()
  {
    std::string error = this->ReadHeader();
    while (error.empty())
    {
      const std::string_view keyword = this->Source.NextWord();
      if (keyword.empty())
      {
        break;
      }
      error = this->ReadSection(keyword);
    }
    if (error.empty() && this->Result.CellTypes.size() != this->Result.Cells.Size())
    {
      error = this->Error("it has " + std::to_string(this->Result.Cells.Size()) +
        " cells but types of " + std::to_string(this->Result.CellTypes.size()));
    }
    return error;
  }

private:
  std::string Error(const std::string& what) const { return NotValid(this->Name, "VTK", what); }
  std::string ErrorHere(const std::string& what) const
  {
    return this->Error(this->Source.Where() + " " + what);
  }
  std::string Incomplete(std::string_view what) const
  {
    return this->Source.IsAtEnd()
      ? this->Error("it ends within its " + std::string(what))
      : this->ErrorHere("has no number where its " + std::string(what) + " need one");
  }

  std::string ReadHeader()
  {
    constexpr std::string_view Mark = "# vtk DataFile";
    const std::string_view first = this->Source.WholeLine();
    if (first.substr(0, Mark.size()) != Mark)
    {
      return this->Error("it does not begin with \"# vtk DataFile\"");
    }
    this->Source.WholeLine(); // the title
    const std::string_view kind = this->Source.NextWord();
    if (kind != "ASCII" && kind != "BINARY")
    {
      return this->ErrorHere("has " + Quoted(kind) + " instead of ASCII or BINARY");
    }
    const std::string_view keyword = this->Source.NextWord();
    const std::string_view dataset = this->Source.NextWord();
    this->Result.IsGrid = dataset == "UNSTRUCTURED_GRID";
    if (keyword != "DATASET" || (!this->Result.IsGrid && dataset != "POLYDATA"))
    {
      return this->ErrorHere("has " + Quoted(dataset) +
        ", but only DATASET POLYDATA and DATASET UNSTRUCTURED_GRID can be read");
    }
    this->Source.RestOfLine();
    this->Source.SetBinary(kind == "BINARY");
    return {};
  }

  std::string ReadSection(std::string_view keyword)
  {
    const Words words = this->Source.RestOfLine();
    LegacyCells* cells = keyword == "VERTICES" ? &this->Result.Vertices
      : keyword == "LINES"                     ? &this->Result.Lines
      : keyword == "POLYGONS"                  ? &this->Result.Polygons
      : keyword == "TRIANGLE_STRIPS"           ? &this->Result.Strips
      : keyword == "CELLS"                     ? &this->Result.Cells
                                               : nullptr;
    if (keyword == "METADATA")
    {
      while (!this->Source.IsAtEnd() && !this->Source.RestOfLine().empty())
      {
      }
      return {};
    }
    if (keyword == "FIELD")
    {
      std::size_t count = 0;
      return words.size() > 1 && this->Count(words[1], count) ? this->ReadField(count)
                                                              : this->Unknown(keyword);
    }
    std::size_t count = 0;
    if (keyword == "POINT_DATA" || keyword == "CELL_DATA")
    {
      if (words.empty() || !this->Count(words[0], count))
      {
        return this->Unknown(keyword);
      }
      this->IsOfPoints = keyword == "POINT_DATA";
      this->IsOfCells = !this->IsOfPoints;
      this->NumberOfTuples = count;
      return {};
    }
    if (this->IsOfPoints || this->IsOfCells)
    {
      return this->ReadAttribute(keyword, words);
    }
    if (words.empty() || !this->Count(words[0], count))
    {
      return this->Unknown(keyword);
    }
    if (keyword == "POINTS" && words.size() > 1)
    {
      return this->ReadPoints(count, words[1]);
    }
    if (keyword == "CELL_TYPES")
    {
      return this->ReadInts("int", count, this->Result.CellTypes) ? std::string()
                                                                  : this->Incomplete("CELL_TYPES");
    }
    std::size_t size = 0;
    if (cells && words.size() > 1 && this->Count(words[1], size))
    {
      const std::string error = this->ReadCells(count, size, *cells);
      return error.empty() ? this->CheckCells(keyword, *cells) : error;
    }
    return this->Unknown(keyword);
  }

  std::string Unknown(std::string_view keyword) const
  {
    return this->ErrorHere("follows what cannot be understood: " + Quoted(keyword));
  }

  /// A number of things, each of which takes an eighth of a byte or more.
  bool Count(std::string_view word, std::size_t& count) const
  {
    std::int64_t number = 0;
    if (!ToNumber(word, number) || number < 0 ||
      static_cast<std::size_t>(number) / 8 > this->Content.size())
    {
      return false;
    }
    count = static_cast<std::size_t>(number);
    return true;
  }

  bool ReadInts(std::string_view type, std::size_t count, std::vector<int>& values)
  {
    FileArray array;
    if (!this->Source.NextNumbers(type, count, array))
    {
      return false;
    }
    values.clear();
    values.reserve(count);
    const auto copy = [&values](const auto& numbers)
    {
      using Number = typename std::decay_t<decltype(numbers)>::value_type;
      constexpr auto Most = static_cast<double>(std::numeric_limits<int>::max());
      for (const Number number : numbers)
      {
        // What no int holds is no index either; the check of the cells says so.
        values.push_back(static_cast<double>(number) >= 0.0 && static_cast<double>(number) < Most
            ? static_cast<int>(number)
            : -1);
      }
    };
    std::visit(copy, array.Values);
    return true;
  }

  std::string ReadPoints(std::size_t count, std::string_view type)
  {
    FileArray array;
    if (count > std::numeric_limits<int>::max() ||
      !this->Source.NextNumbers(type, 3 * count, array))
    {
      return this->Incomplete("POINTS");
    }
    const std::vector<double> coordinates = array.AsDoubles();
    this->Result.Points.resize(count);
    for (std::size_t i = 0; i < coordinates.size(); ++i)
    {
      this->Result.Points[i / 3][i % 3] = coordinates[i];
    }
    return {};
  }

  /// To version 4 each cell as its number of points and these; from 5 on all ends and all points.
  std::string ReadCells(std::size_t count, std::size_t size, LegacyCells& cells)
  {
    cells = LegacyCells();
    const std::string_view rest = this->Source.Rest();
    const bool hasOffsets =
      rest.substr(std::min(rest.size(), rest.find_first_not_of(" \r\n"))).substr(0, 7) == "OFFSETS";
    std::vector<int> numbers;
    if (!hasOffsets)
    {
      if (!this->ReadInts("int", size, numbers))
      {
        return this->Incomplete("cells");
      }
      std::size_t at = 0;
      while (cells.Size() < count && at < numbers.size())
      {
        const auto points = static_cast<std::size_t>(std::max(0, numbers[at]));
        if (points > numbers.size() - at - 1)
        {
          break;
        }
        cells.Points.insert(
          cells.Points.end(), numbers.begin() + at + 1, numbers.begin() + at + 1 + points);
        cells.Starts.push_back(cells.Points.size());
        at += points + 1;
      }
      return cells.Size() == count
        ? std::string()
        : this->Error("cell " + std::to_string(cells.Size()) + " has more points than are there");
    }
    this->Source.NextWord();
    Words words = this->Source.RestOfLine();
    if (words.empty() || !this->ReadInts(words[0], count, numbers))
    {
      return this->Incomplete("OFFSETS");
    }
    const std::string_view keyword = this->Source.NextWord();
    words = this->Source.RestOfLine();
    if (keyword != "CONNECTIVITY" || words.empty() || !this->ReadInts(words[0], size, cells.Points))
    {
      return this->Incomplete("CONNECTIVITY");
    }
    cells.Starts.assign(1, 0);
    for (std::size_t i = 1; i < numbers.size(); ++i)
    {
      const auto end = static_cast<std::size_t>(std::max(0, numbers[i]));
      if (end < cells.Starts.back() || end > cells.Points.size())
      {
        return this->Error(
          "the points of cell " + std::to_string(i - 1) + " are not where it says");
      }
      cells.Starts.push_back(end);
    }
    return {};
  }

  std::string CheckCells(std::string_view keyword, const LegacyCells& cells) const
  {
    const auto numberOfPoints = static_cast<int>(this->Result.Points.size());
    const auto bad = std::find_if(cells.Points.begin(), cells.Points.end(),
      [numberOfPoints](int point) { return point < 0 || point >= numberOfPoints; });
    if (bad == cells.Points.end())
    {
      return {};
    }
    const auto cell = std::upper_bound(cells.Starts.begin(), cells.Starts.end(),
                        static_cast<std::size_t>(bad - cells.Points.begin())) -
      cells.Starts.begin() - 1;
    return this->Error("cell " + std::to_string(cell) + " of its " + std::string(keyword) +
      " uses point " + std::to_string(*bad) + ", but the " + std::to_string(numberOfPoints) +
      " points are numbered from 0");
  }

  std::string ReadAttribute(std::string_view keyword, const Words& words)
  {
    std::size_t components = keyword == "SCALARS" || keyword == "GLOBAL_IDS" ||
        keyword == "PEDIGREE_IDS" || keyword == "EDGE_FLAGS"
      ? 1
      : keyword == "VECTORS" || keyword == "NORMALS" ? 3
      : keyword == "TENSORS"                         ? 9
      : keyword == "TENSORS6"                        ? 6
                                                     : 0;
    if (keyword == "LOOKUP_TABLE" && words.size() > 1 && this->Count(words[1], components))
    {
      FileArray ignored;
      return this->Source.NextColors(4 * components, ignored) ? std::string()
                                                              : this->Incomplete(keyword);
    }
    if (keyword == "COLOR_SCALARS" && words.size() > 1 && this->Count(words[1], components))
    {
      FileArray colors;
      if (!this->Source.NextColors(components * this->NumberOfTuples, colors))
      {
        return this->Incomplete(keyword);
      }
      return this->Add(words[0], components, std::move(colors));
    }
    std::size_t type = 1;
    if (keyword == "TEXTURE_COORDINATES" && words.size() > 2 && this->Count(words[1], components))
    {
      type = 2;
    }
    if (components == 0 || words.size() <= type)
    {
      return this->Unknown(keyword);
    }
    if (keyword == "SCALARS")
    {
      if (words.size() > 2 && !this->Count(words[2], components))
      {
        return this->Unknown(keyword);
      }
      // The name of a look-up table may follow.
      if (this->Source.Rest().substr(0, 12) == "LOOKUP_TABLE")
      {
        this->Source.WholeLine();
      }
    }
    FileArray array;
    if (!this->Source.NextNumbers(words[type], components * this->NumberOfTuples, array))
    {
      return this->Incomplete(keyword);
    }
    return this->Add(words[0], components, std::move(array));
  }

  std::string ReadField(std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      std::string_view name = this->Source.NextWord();
      if (name == "METADATA")
      {
        this->Source.RestOfLine();
        while (!this->Source.IsAtEnd() && !this->Source.RestOfLine().empty())
        {
        }
        name = this->Source.NextWord();
      }
      if (name == "NULL_ARRAY")
      {
        continue;
      }
      const Words words = this->Source.RestOfLine();
      std::size_t components = 0;
      std::size_t tuples = 0;
      if (words.size() < 3 || !this->Count(words[0], components) ||
        !this->Count(words[1], tuples) ||
        (components > 0 && tuples > 8 * this->Content.size() / components))
      {
        return this->Unknown(name);
      }
      std::vector<std::string> strings;
      FileArray array;
      const bool isString = words[2] == "string" || words[2] == "utf8_string";
      if (isString ? !this->Source.NextStrings(components * tuples, strings)
                   : !this->Source.NextNumbers(words[2], components * tuples, array))
      {
        return this->Incomplete(name);
      }
      if (isString)
      {
        if (!this->IsOfPoints && !this->IsOfCells)
        {
          this->Result.FieldStrings.emplace_back(DecodedName(name), std::move(strings));
        }
        continue;
      }
      const std::string error = this->Add(name, components, std::move(array));
      if (!error.empty())
      {
        return error;
      }
    }
    return {};
  }

  std::string Add(std::string_view name, std::size_t components, FileArray array)
  {
    if (components == 0 || components > std::numeric_limits<short>::max())
    {
      return {};
    }
    array.Name = DecodedName(name);
    array.Components = static_cast<int>(components);
    const bool isOfField = !this->IsOfPoints && !this->IsOfCells;
    if (!isOfField && array.NumberOfTuples() != this->NumberOfTuples)
    {
      return this->Error("the array \"" + array.Name + "\" has " +
        std::to_string(array.NumberOfTuples()) + " tuples instead of " +
        std::to_string(this->NumberOfTuples));
    }
    (isOfField             ? this->Result.FieldArrays
        : this->IsOfPoints ? this->Result.PointArrays
                           : this->Result.CellArrays)
      .push_back(std::move(array));
    return {};
  }

  LegacyVTKSource Source;
  std::string_view Content;
  std::string_view Name;
  LegacyVTKData& Result;
  bool IsOfPoints = false;
  bool IsOfCells = false;
  std::size_t NumberOfTuples = 0;
};
}

std::string ReadLegacyVTKFile(
  std::string_view content, std::string_view fileName, LegacyVTKData& data)
{
  data = LegacyVTKData();
  return LegacyVTKParser(content, fileName, data).Parse();
}
}
