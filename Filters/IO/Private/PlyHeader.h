// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PlyHeader_h
#define marrow_PlyHeader_h

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace marrow
{
enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float,
  Double
};

struct PlyProperty
{
  std::string Name;
  PlyType Type = PlyType::Float; ///< of the items, if it is a list
  bool IsList = false;
  PlyType CountType = PlyType::UInt8;
};

struct PlyElement
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<PlyProperty> Properties;
};

struct PlyHeader
{
  bool IsText = true;
  bool IsBigEndian = false;
  std::vector<PlyElement> Elements;
  std::size_t Size = 0; ///< where the data begins
  int Lines = 0;
};

/// Reads what stands up to end_header. Returns one sentence that says what is wrong, or an empty one.
std::string ReadPlyHeader(std::string_view content, std::string_view fileName, PlyHeader& header);
}

#endif
