// SPDX-License-Identifier: BSD-3-Clause
#include "ContentKey.h"

#include <algorithm>
#include <cstring>

namespace marrow
{
namespace
{
/// The finalizer of MurmurHash3: every bit of the result depends on every bit of the word.
std::uint64_t Mix(std::uint64_t word)
{
  word ^= word >> 33;
  word *= 0xff51afd7ed558ccdu;
  word ^= word >> 33;
  word *= 0xc4ceb9fe1a85ec53u;
  return word ^ (word >> 33);
}
}

void ContentKey::AddWord(std::uint64_t word)
{
  this->First = Mix(this->First ^ word);
  this->Second = Mix(this->Second + word) + this->First;
}

void ContentKey::Add(const void* bytes, std::size_t size)
{
  // The size too: what is added in two parts is not the same as in one.
  this->AddWord(size);
  const char* next = static_cast<const char*>(bytes);
  while (size > 0)
  {
    std::uint64_t word = 0;
    const std::size_t step = std::min(size, sizeof(word));
    std::memcpy(&word, next, step);
    this->AddWord(word);
    next += step;
    size -= step;
  }
}

std::string ContentKey::Text() const
{
  std::string text;
  for (std::uint64_t word : { this->First, this->Second })
  {
    for (int digit = 0; digit < 16; ++digit)
    {
      text += "0123456789abcdef"[word >> 60];
      word <<= 4;
    }
  }
  return text;
}
}
