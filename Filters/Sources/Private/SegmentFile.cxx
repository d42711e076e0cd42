// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentFile.h"

#include "TextFile.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace marrow
{
std::string ReadSegmentFile(const std::string& fileName, std::vector<int>& segments)
{
  segments.clear();
  TextFile text;
  const std::string error = text.Open(fileName);
  if (!error.empty())
  {
    return error;
  }
  while (text.NextLine())
  {
    int segment = 0;
    if (text.Words().size() != 1 || !ToNumber(text.Words().front(), segment))
    {
      return "Line " + std::to_string(text.LineNumber()) + " of \"" + fileName +
        "\" is not one integer: a .seg file holds the segment of one face per line.";
    }
    segments.push_back(segment);
  }
  return {};
}

std::string WriteSegmentFile(const std::string& fileName, const std::vector<int>& segments)
{
  std::string text;
  for (const int segment : segments)
  {
    text += std::to_string(segment) + "\n";
  }
  errno = 0;
  std::ofstream stream(fileName, std::ios::binary);
  stream << text;
  stream.close();
  return stream ? std::string()
                : "Cannot write \"" + fileName + "\": " + std::strerror(errno) +
      "; check the folder, its permissions and the space left.";
}
}
