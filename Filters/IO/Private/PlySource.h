// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PlySource_h
#define marrow_PlySource_h

#include "ByteReader.h"
#include "NumberConversion.h"
#include "PlyHeader.h"
#include "TextReader.h"

#include <cstdint>
#include <string>
#include <type_traits>

namespace marrow
{
enum class PlyOutcome
{
  Good,
  End, ///< of the file
  Bad  ///< no number, or none of the type
};

/// The numbers of a PLY file's binary data.
class PlyBytes
{
public:
  PlyBytes(std::string_view content, const PlyHeader& header)
    : Bytes(content, header.Size, header.IsBigEndian)
  {
  }

  void BeginRecord() {}
  template <typename Number>
  PlyOutcome Next(PlyType type, Number& number)
  {
    switch (type)
    {
      case PlyType::Int8:
        return this->NextOf<std::int8_t>(number);
      case PlyType::UInt8:
        return this->NextOf<std::uint8_t>(number);
      case PlyType::Int16:
        return this->NextOf<std::int16_t>(number);
      case PlyType::UInt16:
        return this->NextOf<std::uint16_t>(number);
      case PlyType::Int32:
        return this->NextOf<std::int32_t>(number);
      case PlyType::UInt32:
        return this->NextOf<std::uint32_t>(number);
      case PlyType::Int64:
        return this->NextOf<std::int64_t>(number);
      case PlyType::UInt64:
        return this->NextOf<std::uint64_t>(number);
      case PlyType::Float:
        return this->NextOf<float>(number);
      case PlyType::Double:
        break;
    }
    return this->NextOf<double>(number);
  }

  std::string Where() const { return "byte " + std::to_string(this->Bytes.Position()); }
  std::size_t Left() const { return this->Bytes.Left(); }
  double FractionRead() const { return this->Bytes.FractionRead(); }
  std::string EndError() const { return {}; }

private:
  template <typename Stored, typename Number>
  PlyOutcome NextOf(Number& number)
  {
    Stored stored{};
    if (!this->Bytes.Next(stored))
    {
      return PlyOutcome::End;
    }
    return ConvertNumber(stored, number) ? PlyOutcome::Good : PlyOutcome::Bad;
  }

  ByteReader Bytes;
};

/// The numbers of a PLY file's text: an element stands in a line, but may go on in the next, and several
/// may share one.
class PlyText
{
public:
  PlyText(std::string_view content, const PlyHeader& header)
    : Text(content.substr(header.Size), TextReader::Style::Plain)
    , LinesBefore(header.Lines)
  {
  }

  void BeginRecord()
  {
    const bool shares = this->Word > 0 && this->Word < this->Text.Words().size();
    if (shares && this->FirstSharedLine == 0)
    {
      this->FirstSharedLine = this->Text.LineNumber();
    }
  }
  template <typename Number>
  PlyOutcome Next(PlyType, Number& number)
  {
    if (this->Word == this->Text.Words().size())
    {
      this->Word = 0;
      if (!this->Text.NextLine())
      {
        return PlyOutcome::End;
      }
    }
    const std::string_view word = this->Text.Words()[this->Word++];
    std::int64_t integer = 0;
    double real = 0.0;
    if (std::is_integral_v<Number> && ToNumber(word, integer))
    {
      return ConvertNumber(integer, number) ? PlyOutcome::Good : PlyOutcome::Bad;
    }
    return ToNumber(word, real) && ConvertNumber(real, number) ? PlyOutcome::Good : PlyOutcome::Bad;
  }

  std::string Where() const
  {
    return "line " + std::to_string(this->LinesBefore + this->Text.LineNumber());
  }
  std::size_t Left() const { return this->Text.Size() - this->Text.BytesRead(); }
  double FractionRead() const { return this->Text.FractionRead(); }

  /// Elements that share lines and end before the file does had more numbers than they should.
  std::string EndError()
  {
    const bool isLeft = this->Word < this->Text.Words().size() || this->Text.NextLine();
    return isLeft && this->FirstSharedLine > 0
      ? "line " + std::to_string(this->LinesBefore + this->FirstSharedLine) +
        " has more numbers than the header promises"
      : std::string();
  }

private:
  TextReader Text;
  int LinesBefore;
  std::size_t Word = 0;
  int FirstSharedLine = 0;
};
}

#endif
