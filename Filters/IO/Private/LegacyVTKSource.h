// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LegacyVTKSource_h
#define marrow_LegacyVTKSource_h

#include "FileMesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace marrow
{
/// Words, and numbers in text or binary, of a file of VTK's older kind; never beyond its end.
class LegacyVTKSource
{
public:
  explicit LegacyVTKSource(std::string_view content)
    : Text(content)
  {
  }

  void SetBinary(bool isBinary) { this->IsBinary = isBinary; }

  /// The next word, empty at the end.
  std::string_view NextWord();
  /// The rest of the line, the words separated.
  std::vector<std::string_view> RestOfLine();
  std::string_view WholeLine();

  /// `count` numbers of the type with that name in the array's own type; false if it is none that is
  /// known, if they are no numbers of it, or the file ends before.
  bool NextNumbers(std::string_view type, std::size_t count, FileArray& array);
  /// Colours, bytes where the file is binary, else fractions.
  bool NextColors(std::size_t count, FileArray& array);
  bool NextStrings(std::size_t count, std::vector<std::string>& strings);

  /// "line 7", or where lines say nothing "byte 500".
  std::string Where() const;
  std::string_view Rest() const { return this->Text.substr(this->At); }
  bool IsAtEnd() const { return this->At >= this->Text.size(); }

private:
  template <typename Stored, typename Kept>
  bool NextOf(std::size_t count, FileArray& array);
  bool NextBits(std::size_t count, FileArray& array);
  void SkipLineEnd();

  std::string_view Text;
  std::size_t At = 0;
  bool IsBinary = false;
};

/// A name in a file, in which blanks and the like are written as %20.
std::string DecodedName(std::string_view name);
}

#endif
