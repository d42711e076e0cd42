// SPDX-License-Identifier: BSD-3-Clause
#include "PartNumbers.h"

#include "SegmentColors.h"
#include "TextReader.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace marrow
{
namespace
{
constexpr std::string_view SegmentPrefix = "segment_";

/// The same before its number in all names, and these numbers; false if that is not so.
bool SplitNames(
  const std::vector<std::string>& names, std::string& prefix, std::vector<int>& numbers)
{
  numbers.clear();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::string& name = names[i];
    std::size_t begin = name.size();
    while (begin > 0 && name[begin - 1] >= '0' && name[begin - 1] <= '9')
    {
      --begin;
    }
    const bool isNegative =
      begin > 0 && name[begin - 1] == '-' && name.substr(0, begin - 1) == SegmentPrefix;
    begin -= isNegative ? 1 : 0;
    int number = 0;
    if (!ToNumber(std::string_view(name).substr(begin), number) ||
      (i > 0 && name.substr(0, begin) != prefix))
    {
      return false;
    }
    prefix = name.substr(0, begin);
    numbers.push_back(number);
  }
  return !names.empty();
}

/// Ids by the order of the keys.
template <typename Key>
std::vector<int> PlacesOf(const std::vector<Key>& keys)
{
  std::map<Key, int> places;
  for (const Key& key : keys)
  {
    places[key] = 0;
  }
  int next = 0;
  for (auto& [key, place] : places)
  {
    place = next++;
  }
  std::vector<int> ids;
  for (const Key& key : keys)
  {
    ids.push_back(places[key]);
  }
  return ids;
}

std::vector<std::string> NamesByIds(
  const std::vector<int>& ids, const std::vector<std::string>& names)
{
  std::vector<std::string> byId;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    byId.resize(std::max<std::size_t>(byId.size(), ids[i] + 1));
    byId[ids[i]] = names[i];
  }
  return byId;
}
}

NumberedParts NumberParts(const std::vector<std::string>& names)
{
  NumberedParts parts;
  std::string prefix;
  // Labels of 16 bits, so that the table of names stays short.
  constexpr int Largest = 65535;
  const bool hasNumbers = SplitNames(names, prefix, parts.IdOfPart);
  if (hasNumbers && prefix == SegmentPrefix)
  {
    return parts;
  }
  const bool isDistinct = hasNumbers &&
    [&]
  {
    std::vector<int> sorted = parts.IdOfPart;
    std::sort(sorted.begin(), sorted.end());
    return sorted.back() <= Largest &&
      std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }();
  if (!isDistinct)
  {
    parts.IdOfPart = PlacesOf(names);
  }
  parts.NameOfId = NamesByIds(parts.IdOfPart, names);
  return parts;
}

NumberedParts NumberColors(const std::vector<FileColor>& colors)
{
  NumberedParts parts;
  std::vector<std::string> names;
  for (const FileColor& color : colors)
  {
    const int label = LabelOfColor(color);
    if (label != NotAColorOfLabels)
    {
      parts.IdOfPart.push_back(label);
    }
    names.push_back(NameOfColor(color));
  }
  if (parts.IdOfPart.size() < colors.size())
  {
    parts.IdOfPart = PlacesOf(colors);
    parts.NameOfId = NamesByIds(parts.IdOfPart, names);
  }
  return parts;
}

std::string NameOfSegment(int id)
{
  return std::string(SegmentPrefix) + std::to_string(id);
}

std::string NameOfColor(const FileColor& color)
{
  constexpr const char* Digits = "0123456789abcdef";
  std::string name = "#";
  for (std::size_t k = 0; k < (color[3] == 255 ? 3 : 4); ++k)
  {
    name += Digits[color[k] / 16];
    name += Digits[color[k] % 16];
  }
  return name;
}

bool ColorOfName(const std::string& name, FileColor& color)
{
  if ((name.size() != 7 && name.size() != 9) || name[0] != '#')
  {
    return false;
  }
  color[3] = 255;
  for (std::size_t k = 0; 2 * k + 1 < name.size(); ++k)
  {
    const char* begin = name.data() + 1 + 2 * k;
    if (std::from_chars(begin, begin + 2, color[k], 16).ptr != begin + 2)
    {
      return false;
    }
  }
  return true;
}

int MostFrequent(std::vector<int> labels)
{
  std::sort(labels.begin(), labels.end());
  int best = labels.front();
  std::size_t most = 0;
  for (auto begin = labels.begin(); begin != labels.end();)
  {
    const auto end = std::upper_bound(begin, labels.end(), *begin);
    if (static_cast<std::size_t>(end - begin) > most)
    {
      most = end - begin;
      best = *begin;
    }
    begin = end;
  }
  return best;
}
}
