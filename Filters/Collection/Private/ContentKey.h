// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ContentKey_h
#define marrow_ContentKey_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace marrow
{
/// A key of 128 bits made of bytes: that two contents share one by chance is out of the question. It keeps
/// results apart, and is not meant to withstand someone who wants them mixed up.
class ContentKey
{
public:
  void Add(const void* bytes, std::size_t size);

  /// 32 hexadecimal digits.
  std::string Text() const;

private:
  void AddWord(std::uint64_t word);

  std::uint64_t First = 0x9e3779b97f4a7c15u;
  std::uint64_t Second = 0xc2b2ae3d27d4eb4fu;
};
}

#endif
