// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentFile_h
#define marrow_SegmentFile_h

#include <string>
#include <vector>

namespace marrow
{
/// Reads a .seg file: one integer a line. Returns one sentence that says what is wrong, or an empty
/// one.
std::string ReadSegmentFile(const std::string& fileName, std::vector<int>& segments);

/// Writes one. Returns one sentence that says what is wrong, or an empty one.
std::string WriteSegmentFile(const std::string& fileName, const std::vector<int>& segments);
}

#endif
