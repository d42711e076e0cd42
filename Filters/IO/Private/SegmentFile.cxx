// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentFile.h"

#include "TextReader.h"

namespace marrow
{
std::string ReadSegmentFile(
  std::string_view content, std::string_view fileName, std::vector<int>& segments)
{
  segments.clear();
  TextReader text(content);
  while (text.NextLine())
  {
    int segment = 0;
    if (text.Words().size() != 1 || !ToNumber(text.Words().front(), segment))
    {
      return "Line " + std::to_string(text.LineNumber()) + " of \"" + std::string(fileName) +
        "\" is not one integer: a .seg file holds the segment of one face per line.";
    }
    segments.push_back(segment);
  }
  return {};
}

std::string SegmentFileText(const std::vector<int>& segments)
{
  std::string text;
  for (const int segment : segments)
  {
    text += std::to_string(segment) + "\n";
  }
  return text;
}
}
