// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentFile_h
#define marrow_SegmentFile_h

#include <string>
#include <string_view>
#include <vector>

namespace marrow
{
/// Reads the content of a .seg file: one integer a line. Returns one sentence that says what is wrong,
/// or an empty one.
std::string ReadSegmentFile(
  std::string_view content, std::string_view fileName, std::vector<int>& segments);

/// The content of a .seg file.
std::string SegmentFileText(const std::vector<int>& segments);
}

#endif
