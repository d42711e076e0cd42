// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentColors.h"

#include "LabelPalette.h"
#include "PartNumbers.h"

#include <algorithm>
#include <set>

namespace marrow
{
namespace
{
FileColor Opaque(const std::array<unsigned char, 3>& rgb)
{
  return { rgb[0], rgb[1], rgb[2], 255 };
}
}

std::map<int, FileColor> ColorsOfSegments(
  const std::vector<int>& labels, const std::vector<std::string>& nameOfLabel)
{
  std::map<int, FileColor> colors;
  std::set<FileColor> taken;
  std::vector<int> rest;
  for (const int label : std::set<int>(labels.begin(), labels.end()))
  {
    FileColor color;
    const bool isNamed = label >= 0 && label < static_cast<int>(nameOfLabel.size()) &&
      ColorOfName(nameOfLabel[label], color);
    if (isNamed && taken.insert(color).second)
    {
      colors[label] = color;
    }
    else
    {
      rest.push_back(label);
    }
  }
  for (const int label : rest)
  {
    FileColor color = Opaque(label < 0 ? NoLabelColor : LabelPalette[label % LabelPalette.size()]);
    while (!taken.insert(color).second)
    {
      // Counts on through the least visible component first.
      for (const int component : { 2, 0, 1 })
      {
        if (++color[component] != 0)
        {
          break;
        }
      }
    }
    colors[label] = color;
  }
  return colors;
}

int LabelOfColor(const FileColor& color)
{
  if (color == Opaque(NoLabelColor))
  {
    return -1;
  }
  const auto found = std::find_if(LabelPalette.begin(), LabelPalette.end(),
    [&color](const auto& rgb) { return Opaque(rgb) == color; });
  return found == LabelPalette.end() ? NotAColorOfLabels
                                     : static_cast<int>(found - LabelPalette.begin());
}
}
