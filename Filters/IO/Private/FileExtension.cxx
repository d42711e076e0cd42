// SPDX-License-Identifier: BSD-3-Clause
#include "FileExtension.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <vector>

namespace marrow
{
namespace
{
std::string InSmallLetters(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}
}

std::string ExtensionOfFormat(const std::string& fileName)
{
  std::filesystem::path name = InSmallLetters(fileName);
  if (name.extension() == ".gz")
  {
    name = name.stem();
  }
  return name.extension().string();
}

std::string CheckExtension(const std::string& fileName, const std::string& extensions)
{
  std::istringstream words(extensions);
  std::vector<std::string> known;
  for (std::string word; words >> word;)
  {
    known.push_back(word);
  }
  const std::string name = InSmallLetters(fileName);
  const bool isKnown = std::any_of(known.begin(), known.end(),
    [&name](const std::string& ending)
    {
      return name.size() >= ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    });
  if (isKnown)
  {
    return {};
  }
  std::string list;
  for (std::size_t i = 0; i < known.size(); ++i)
  {
    list += (i == 0 ? "" : i + 1 < known.size() ? ", " : " or ") + known[i];
  }
  return "\"" + fileName + "\" is of no known format: the name must end in " + list + ".";
}
}
