// SPDX-License-Identifier: BSD-3-Clause
#include "FileMesh.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// The columns of these names and one type; empty if one is missing.
std::vector<std::size_t> Find(
  const std::vector<FileArray>& arrays, const std::vector<const char*>& names)
{
  std::vector<std::size_t> found;
  for (const char* name : names)
  {
    const auto at = std::find_if(
      arrays.begin(), arrays.end(), [name](const FileArray& array) { return array.Name == name; });
    if (at == arrays.end())
    {
      return {};
    }
    found.push_back(at - arrays.begin());
  }
  return found;
}

void Replace(
  std::vector<FileArray>& arrays, std::vector<std::size_t> columns, const FileArray& joined)
{
  std::sort(columns.begin(), columns.end());
  for (auto column = columns.rbegin(); column != columns.rend(); ++column)
  {
    arrays.erase(arrays.begin() + *column);
  }
  arrays.push_back(joined);
}

std::vector<double> Interleaved(
  const std::vector<FileArray>& arrays, const std::vector<std::size_t>& columns)
{
  const std::size_t size = arrays[columns.front()].NumberOfTuples();
  std::vector<double> values(size * columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    const std::vector<double> column = arrays[columns[k]].AsDoubles();
    for (std::size_t i = 0; i < size; ++i)
    {
      values[i * columns.size() + k] = column[i];
    }
  }
  return values;
}

void JoinColors(std::vector<FileArray>& arrays)
{
  std::vector<std::size_t> columns = Find(arrays, { "red", "green", "blue", "alpha" });
  if (columns.empty())
  {
    columns = Find(arrays, { "red", "green", "blue" });
  }
  if (columns.empty())
  {
    return;
  }
  const auto isOneOf = [&](auto... example)
  {
    return std::all_of(columns.begin(), columns.end(),
      [&](std::size_t column)
      { return (... || std::holds_alternative<decltype(example)>(arrays[column].Values)); });
  };
  const bool isFraction = isOneOf(std::vector<float>(), std::vector<double>());
  if (!isFraction && !isOneOf(std::vector<std::uint8_t>()))
  {
    return;
  }
  const std::vector<double> values = Interleaved(arrays, columns);
  std::vector<FileColor> colors(values.size() / columns.size(), FileColor{ 0, 0, 0, 255 });
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    colors[i / columns.size()][i % columns.size()] =
      ColorComponent(isFraction ? 255.0 * values[i] : values[i]);
  }
  Replace(arrays, columns, ColorArray(colors));
}

void JoinReals(
  std::vector<FileArray>& arrays, const std::vector<const char*>& names, const char* joined)
{
  const std::vector<std::size_t> columns = Find(arrays, names);
  if (!columns.empty())
  {
    Replace(
      arrays, columns, { joined, Interleaved(arrays, columns), static_cast<int>(columns.size()) });
  }
}
}

std::size_t FileArray::NumberOfTuples() const
{
  return std::visit([](const auto& values) { return values.size(); }, this->Values) /
    this->Components;
}

std::vector<double> FileArray::AsDoubles() const
{
  return std::visit([](const auto& values)
    { return std::vector<double>(values.begin(), values.end()); },
    this->Values);
}

void FileParts::Begin(const std::string& name)
{
  const auto [found, isNew] = this->Numbers.emplace(name, static_cast<int>(this->Names.size()));
  if (isNew)
  {
    this->Names.push_back(name);
  }
  this->Current = found->second;
}

void FileParts::AddFace()
{
  if (this->Current < 0)
  {
    this->Begin("");
  }
  this->Ids.push_back(this->Current);
}

unsigned char ColorComponent(double value)
{
  return std::isfinite(value)
    ? static_cast<unsigned char>(std::lround(std::clamp(value, 0.0, 255.0)))
    : 0;
}

FileArray ColorArray(const std::vector<FileColor>& colors)
{
  std::vector<std::uint8_t> values;
  values.reserve(4 * colors.size());
  for (const FileColor& color : colors)
  {
    values.insert(values.end(), color.begin(), color.end());
  }
  return { ColorsName, std::move(values), 4 };
}

void JoinColumns(std::vector<FileArray>& arrays)
{
  JoinColors(arrays);
  JoinReals(arrays, { "nx", "ny", "nz" }, NormalsName);
  for (const auto& names :
    { std::vector<const char*>{ "s", "t" }, { "u", "v" }, { "texture_u", "texture_v" } })
  {
    JoinReals(arrays, names, TextureCoordinatesName);
  }
}

std::string NotValid(std::string_view fileName, const char* format, const std::string& what)
{
  return "\"" + std::string(fileName) + "\" is not a valid " + format + " file: " + what + ".";
}
}
