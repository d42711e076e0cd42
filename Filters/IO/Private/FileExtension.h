// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FileExtension_h
#define marrow_FileExtension_h

#include <string>

namespace marrow
{
/// The extension of a file's name in lower case: ".off", also of "CAMEL.OFF.GZ".
std::string ExtensionOfFormat(const std::string& fileName);

/// One sentence if the name ends in none of `extensions`, which spaces separate; else an empty one.
std::string CheckExtension(const std::string& fileName, const std::string& extensions);
}

#endif
