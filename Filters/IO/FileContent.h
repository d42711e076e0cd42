// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FileContent_h
#define marrow_FileContent_h

#include <string>

namespace marrow
{
/// Reads a whole file, unpacked if it is compressed by gzip, whatever its name. Returns one sentence
/// that says what is wrong, or an empty one.
std::string ReadFileContent(const std::string& fileName, std::string& content);
}

#endif
