// SPDX-License-Identifier: BSD-3-Clause
#include "TextReader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

namespace marrow
{
namespace
{
enum Kind : unsigned char
{
  Letter,
  Blank,
  LineEnd
};

constexpr std::array<unsigned char, 256> KindsOfBytes()
{
  std::array<unsigned char, 256> kinds{};
  for (const unsigned char blank : { ' ', '\t', '\v', '\f', '\0' })
  {
    kinds[blank] = Blank;
  }
  kinds['\n'] = LineEnd;
  kinds['\r'] = LineEnd;
  return kinds;
}

Kind KindOf(char c)
{
  static constexpr std::array<unsigned char, 256> kinds = KindsOfBytes();
  return static_cast<Kind>(kinds[static_cast<unsigned char>(c)]);
}

template <typename Number>
std::errc Convert(std::string_view word, Number& value)
{
  // Streams allow a leading plus, from_chars does not.
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return end == word.data() + word.size() ? error : std::errc::invalid_argument;
}
}

TextReader::TextReader(std::string_view text, Style style)
  : Text(text)
  , Rules(style)
{
  constexpr std::string_view ByteOrderMark("\xEF\xBB\xBF");
  if (text.substr(0, ByteOrderMark.size()) == ByteOrderMark)
  {
    this->Position = ByteOrderMark.size();
  }
}

/// The position behind the line end that begins here.
std::size_t TextReader::LineEndAt(std::size_t position) const
{
  return position + (this->Text.substr(position, 2) == "\r\n" ? 2 : 1);
}

bool TextReader::IsContinuedAt(std::size_t position) const
{
  return this->Rules == Style::WaveFront && this->Text[position] == '\\' &&
    position + 1 < this->Text.size() && KindOf(this->Text[position + 1]) == LineEnd;
}

bool TextReader::NextLine()
{
  this->Line.clear();
  const std::size_t size = this->Text.size();
  std::size_t at = this->Position;
  while (this->Line.empty() && at < size)
  {
    this->Number = ++this->LinesRead;
    while (at < size && KindOf(this->Text[at]) != LineEnd)
    {
      if (KindOf(this->Text[at]) == Blank)
      {
        ++at;
      }
      else if (this->Text[at] == '#' && this->Rules != Style::Plain)
      {
        at = std::min(size, this->Text.find_first_of("\r\n", at));
      }
      else if (this->IsContinuedAt(at))
      {
        at = this->LineEndAt(at + 1);
        ++this->LinesRead;
      }
      else
      {
        const std::size_t first = at;
        while (at < size && KindOf(this->Text[at]) == Letter &&
          !(this->Text[at] == '#' && this->Rules == Style::Comments) && !this->IsContinuedAt(at))
        {
          ++at;
        }
        this->Line.push_back(this->Text.substr(first, at - first));
      }
    }
    at = at < size ? this->LineEndAt(at) : size;
  }
  this->Position = at;
  return !this->Line.empty();
}

bool ToNumber(std::string_view word, double& value)
{
  const std::errc error = Convert(word, value);
  if (error == std::errc::result_out_of_range)
  {
    value = std::strtod(std::string(word).c_str(), nullptr);
    return true;
  }
  return error == std::errc();
}

bool ToNumber(std::string_view word, int& value)
{
  return Convert(word, value) == std::errc();
}

bool ToNumber(std::string_view word, std::int64_t& value)
{
  return Convert(word, value) == std::errc();
}

std::string Quoted(std::string_view word)
{
  constexpr std::size_t Longest = 20;
  const std::string text(word.substr(0, Longest));
  const bool isText =
    std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= 32 && c < 127; });
  return isText ? "\"" + text + (word.size() > Longest ? "...\"" : "\"")
                : std::string("bytes that are not text");
}
}
