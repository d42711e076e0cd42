// SPDX-License-Identifier: BSD-3-Clause
#include "PlyHeader.h"

#include "FileMesh.h"
#include "TextReader.h"

#include <algorithm>
#include <utility>

namespace marrow
{
namespace
{
bool ToType(std::string_view word, PlyType& type)
{
  static constexpr std::pair<std::string_view, PlyType> names[] = { { "char", PlyType::Int8 },
    { "int8", PlyType::Int8 }, { "uchar", PlyType::UInt8 }, { "uint8", PlyType::UInt8 },
    { "short", PlyType::Int16 }, { "int16", PlyType::Int16 }, { "ushort", PlyType::UInt16 },
    { "uint16", PlyType::UInt16 }, { "int", PlyType::Int32 }, { "int32", PlyType::Int32 },
    { "uint", PlyType::UInt32 }, { "uint32", PlyType::UInt32 }, { "int64", PlyType::Int64 },
    { "long", PlyType::Int64 }, { "uint64", PlyType::UInt64 }, { "ulong", PlyType::UInt64 },
    { "float", PlyType::Float }, { "float32", PlyType::Float }, { "double", PlyType::Double },
    { "float64", PlyType::Double } };
  const auto found = std::find_if(
    std::begin(names), std::end(names), [word](const auto& name) { return name.first == word; });
  if (found == std::end(names))
  {
    return false;
  }
  type = found->second;
  return true;
}

using Words = std::vector<std::string_view>;

bool ReadFormat(const Words& words, PlyHeader& header)
{
  if (words.size() < 2)
  {
    return false;
  }
  header.IsText = words[1] == "ascii";
  header.IsBigEndian = words[1] == "binary_big_endian";
  return header.IsText || header.IsBigEndian || words[1] == "binary_little_endian";
}

bool ReadElement(const Words& words, PlyHeader& header)
{
  PlyElement element;
  if (words.size() < 3 || !ToNumber(words[2], element.Count) || element.Count < 0)
  {
    return false;
  }
  element.Name = words[1];
  if (std::any_of(header.Elements.begin(), header.Elements.end(),
        [&element](const PlyElement& other) { return other.Name == element.Name; }))
  {
    return false;
  }
  header.Elements.push_back(element);
  return true;
}

bool ReadProperty(const Words& words, PlyHeader& header)
{
  PlyProperty property;
  property.IsList = words.size() > 1 && words[1] == "list";
  const std::size_t type = property.IsList ? 3 : 1;
  if (header.Elements.empty() || words.size() < type + 2 || !ToType(words[type], property.Type) ||
    (property.IsList && !ToType(words[2], property.CountType)))
  {
    return false;
  }
  property.Name = words[type + 1];
  header.Elements.back().Properties.push_back(property);
  return true;
}
}

std::string ReadPlyHeader(std::string_view content, std::string_view fileName, PlyHeader& header)
{
  header = PlyHeader();
  const auto error = [fileName](const std::string& what)
  { return NotValid(fileName, "PLY", what); };
  TextReader text(content, TextReader::Style::Plain);
  if (!text.NextLine())
  {
    return error("it is empty");
  }
  if (text.Words().front() != "ply")
  {
    return error("it begins with " + Quoted(text.Words().front()) + " instead of ply");
  }
  bool hasFormat = false;
  while (text.NextLine())
  {
    const Words& words = text.Words();
    const std::string_view keyword = words.front();
    bool isRight = true;
    if (keyword == "end_header")
    {
      if (!hasFormat)
      {
        return error("its header does not say in which format it is");
      }
      header.Size = text.BytesRead();
      header.Lines = text.LineNumber();
      return {};
    }
    if (keyword == "format")
    {
      isRight = ReadFormat(words, header);
      hasFormat = true;
    }
    else if (keyword == "element")
    {
      isRight = ReadElement(words, header);
    }
    else if (keyword == "property")
    {
      isRight = ReadProperty(words, header);
    }
    else if (keyword != "comment" && keyword != "obj_info")
    {
      isRight = false;
    }
    if (!isRight)
    {
      std::string line;
      for (const std::string_view word : words)
      {
        line += (line.empty() ? "" : " ") + std::string(word);
      }
      return error("line " + std::to_string(text.LineNumber()) +
        " of its header cannot be understood: " + Quoted(line));
    }
  }
  return error("its header has no end");
}
}
