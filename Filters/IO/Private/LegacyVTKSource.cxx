// SPDX-License-Identifier: BSD-3-Clause
#include "LegacyVTKSource.h"

#include "ByteReader.h"
#include "NumberConversion.h"
#include "TextReader.h"

#include <algorithm>
#include <charconv>

namespace marrow
{
namespace
{
constexpr std::string_view Blanks(" \t\r\n\v\f\0", 7);
}

std::string_view LegacyVTKSource::NextWord()
{
  this->At = std::min(this->Text.size(), this->Text.find_first_not_of(Blanks, this->At));
  const std::size_t end = std::min(this->Text.size(), this->Text.find_first_of(Blanks, this->At));
  const std::string_view word = this->Text.substr(this->At, end - this->At);
  this->At = end;
  return word;
}

std::string_view LegacyVTKSource::WholeLine()
{
  const std::size_t end = std::min(this->Text.size(), this->Text.find_first_of("\r\n", this->At));
  const std::string_view line = this->Text.substr(this->At, end - this->At);
  this->At = end;
  this->SkipLineEnd();
  return line;
}

std::vector<std::string_view> LegacyVTKSource::RestOfLine()
{
  TextReader line(this->WholeLine(), TextReader::Style::Plain);
  line.NextLine();
  return line.Words();
}

void LegacyVTKSource::SkipLineEnd()
{
  const std::string_view rest = this->Text.substr(this->At, 2);
  this->At += rest == "\r\n" ? 2 : (rest.empty() || (rest[0] != '\n' && rest[0] != '\r') ? 0 : 1);
}

template <typename Stored, typename Kept>
bool LegacyVTKSource::NextOf(std::size_t count, FileArray& array)
{
  std::vector<Kept> values;
  // A file too short for what it promises must not make us allocate that.
  const std::size_t left = this->Text.size() - this->At;
  values.reserve(std::min(count, left));
  if (this->IsBinary)
  {
    ByteReader bytes(this->Text, this->At, true);
    Stored stored{};
    while (values.size() < count)
    {
      if (!bytes.Next(stored))
      {
        return false;
      }
      values.push_back(static_cast<Kept>(stored));
    }
    this->At = bytes.Position();
  }
  while (values.size() < count)
  {
    const std::string_view word = this->NextWord();
    std::int64_t integer = 0;
    double real = 0.0;
    Kept value{};
    const bool isNumber = std::is_integral_v<Kept> && ToNumber(word, integer)
      ? ConvertNumber(integer, value)
      : ToNumber(word, real) && ConvertNumber(real, value);
    if (!isNumber)
    {
      return false;
    }
    values.push_back(value);
  }
  array.Values = std::move(values);
  return true;
}

/// Eight in a byte where the file is binary.
bool LegacyVTKSource::NextBits(std::size_t count, FileArray& array)
{
  if (!this->IsBinary)
  {
    return this->NextOf<std::uint8_t, std::uint8_t>(count, array);
  }
  const std::string_view bytes = this->Text.substr(this->At, count / 8 + (count % 8 > 0 ? 1 : 0));
  if (bytes.size() * 8 < count)
  {
    return false;
  }
  std::vector<std::uint8_t> bits;
  for (std::size_t i = 0; i < count; ++i)
  {
    bits.push_back(static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1U);
  }
  this->At += bytes.size();
  array.Values = std::move(bits);
  return true;
}

bool LegacyVTKSource::NextNumbers(std::string_view type, std::size_t count, FileArray& array)
{
  const auto is = [type](auto... names) { return (... || (type == names)); };
  return is("bit")                        ? this->NextBits(count, array)
    : is("unsigned_char")                 ? this->NextOf<std::uint8_t, std::uint8_t>(count, array)
    : is("char", "signed_char")           ? this->NextOf<std::int8_t, std::int8_t>(count, array)
    : is("unsigned_short")                ? this->NextOf<std::uint16_t, std::uint16_t>(count, array)
    : is("short")                         ? this->NextOf<std::int16_t, std::int16_t>(count, array)
    : is("unsigned_int")                  ? this->NextOf<std::uint32_t, std::uint32_t>(count, array)
    : is("int", "vtkIdType", "vtkidtype") ? this->NextOf<std::int32_t, std::int32_t>(count, array)
    : is("long", "vtktypeint64")          ? this->NextOf<std::int64_t, std::int64_t>(count, array)
    : is("unsigned_long", "vtktypeuint64")
    ? this->NextOf<std::uint64_t, std::uint64_t>(count, array)
    : is("float")  ? this->NextOf<float, float>(count, array)
    : is("double") ? this->NextOf<double, double>(count, array)
                   : false;
}

bool LegacyVTKSource::NextColors(std::size_t count, FileArray& array)
{
  if (this->IsBinary)
  {
    return this->NextOf<std::uint8_t, std::uint8_t>(count, array);
  }
  if (!this->NextOf<double, double>(count, array))
  {
    return false;
  }
  std::vector<std::uint8_t> bytes;
  for (const double value : std::get<std::vector<double>>(array.Values))
  {
    bytes.push_back(ColorComponent(255.0 * value));
  }
  array.Values = std::move(bytes);
  return true;
}

bool LegacyVTKSource::NextStrings(std::size_t count, std::vector<std::string>& strings)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    if (this->IsAtEnd())
    {
      return false;
    }
    if (!this->IsBinary)
    {
      strings.push_back(DecodedName(this->WholeLine()));
      continue;
    }
    // The first two bits tell of how many bytes the length is.
    const auto first = static_cast<unsigned char>(this->Text[this->At]);
    const std::size_t sizeOfLength = std::size_t(8) >> (first >> 6);
    std::uint64_t length = first & 0x3FU;
    for (std::size_t k = 1; k < sizeOfLength; ++k)
    {
      const std::size_t at = this->At + k;
      length =
        length << 8 | (at < this->Text.size() ? static_cast<unsigned char>(this->Text[at]) : 0U);
    }
    const std::size_t begin = this->At + sizeOfLength;
    if (begin > this->Text.size() || length > this->Text.size() - begin)
    {
      return false;
    }
    strings.emplace_back(this->Text.substr(begin, length));
    this->At = begin + length;
  }
  return true;
}

std::string LegacyVTKSource::Where() const
{
  return this->IsBinary ? "byte " + std::to_string(this->At)
                        : "line " +
      std::to_string(1 + std::count(this->Text.begin(), this->Text.begin() + this->At, '\n'));
}

std::string DecodedName(std::string_view name)
{
  std::string decoded;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    unsigned char code = 0;
    const char* digits = name.data() + i + 1;
    if (name[i] == '%' && i + 2 < name.size() &&
      std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2)
    {
      decoded += static_cast<char>(code);
      i += 2;
    }
    else
    {
      decoded += name[i];
    }
  }
  return decoded;
}
}
