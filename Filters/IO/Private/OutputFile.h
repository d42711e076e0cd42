// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_OutputFile_h
#define marrow_OutputFile_h

#include <string>
#include <string_view>

namespace marrow
{
/// Writes a file: all of it beside its place first, so that under its name there is never a part of it,
/// nor is an older file lost when the disk is full. What is no plain file, such as a device, and a file
/// in a folder that takes no new ones are written in place. Returns one sentence that says what is wrong,
/// or an empty one.
std::string WriteOutputFile(const std::string& fileName, std::string_view content);
}

#endif
