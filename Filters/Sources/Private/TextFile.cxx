// SPDX-License-Identifier: BSD-3-Clause
#include "TextFile.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace marrow
{
namespace
{
template <typename Number>
bool Convert(std::string_view word, Number& value)
{
  // Streams allow a leading plus, from_chars does not.
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}
}

std::string TextFile::Open(const std::string& fileName)
{
  *this = TextFile();
  std::error_code ignored;
  if (std::filesystem::is_directory(fileName, ignored))
  {
    return "Cannot read \"" + fileName + "\": it is a folder; name a file.";
  }
  errno = 0;
  std::ifstream stream(fileName, std::ios::binary);
  if (!stream)
  {
    return "Cannot read \"" + fileName + "\": " + std::strerror(errno) +
      "; check the name and the permissions.";
  }
  this->Text.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  return {};
}

bool TextFile::NextLine()
{
  this->Line.clear();
  const std::string_view text = this->Text;
  while (this->Line.empty() && this->Position < text.size())
  {
    const std::size_t end = std::min(text.size(), text.find_first_of("\r\n", this->Position));
    std::string_view line = text.substr(this->Position, end - this->Position);
    const bool isPair = text.substr(end, 2) == "\r\n";
    this->Position = std::min(text.size(), end + (isPair ? 2 : 1));
    ++this->Number;

    line = line.substr(0, line.find('#'));
    constexpr std::string_view Blanks(" \t\v\f\0", 5);
    for (std::size_t first = line.find_first_not_of(Blanks); first != std::string_view::npos;)
    {
      const std::size_t last = std::min(line.size(), line.find_first_of(Blanks, first));
      this->Line.push_back(line.substr(first, last - first));
      first = line.find_first_not_of(Blanks, last);
    }
  }
  return !this->Line.empty();
}

bool ToNumber(std::string_view word, double& value)
{
  return Convert(word, value);
}

bool ToNumber(std::string_view word, int& value)
{
  return Convert(word, value);
}
}
