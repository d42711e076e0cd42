// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ByteReader_h
#define marrow_ByteReader_h

#include <algorithm>
#include <cstring>
#include <string_view>

namespace marrow
{
/// Takes numbers of either byte order out of bytes, never beyond their end.
class ByteReader
{
public:
  ByteReader(std::string_view bytes, std::size_t begin, bool isBigEndian)
    : Bytes(bytes)
    , At(std::min(begin, bytes.size()))
    , Swaps(isBigEndian == IsLittleEndianMachine())
  {
  }

  /// False, and nothing is taken, if too few bytes are left.
  template <typename Number>
  bool Next(Number& number)
  {
    if (this->Left() < sizeof(Number))
    {
      return false;
    }
    char bytes[sizeof(Number)];
    std::memcpy(bytes, this->Bytes.data() + this->At, sizeof(Number));
    if (this->Swaps)
    {
      std::reverse(bytes, bytes + sizeof(Number));
    }
    std::memcpy(&number, bytes, sizeof(Number));
    this->At += sizeof(Number);
    return true;
  }

  std::size_t Left() const { return this->Bytes.size() - this->At; }
  std::size_t Position() const { return this->At; }
  double FractionRead() const
  {
    return this->Bytes.empty() ? 1.0 : static_cast<double>(this->At) / this->Bytes.size();
  }

private:
  static bool IsLittleEndianMachine()
  {
    const unsigned short one = 1;
    unsigned char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 1;
  }

  std::string_view Bytes;
  std::size_t At;
  bool Swaps;
};
}

#endif
