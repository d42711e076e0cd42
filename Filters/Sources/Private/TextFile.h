// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TextFile_h
#define marrow_TextFile_h

#include <string>
#include <string_view>
#include <vector>

namespace marrow
{
/// A text file in memory, read line by line; any line ends.
class TextFile
{
public:
  /// Returns one sentence that says what is wrong, or an empty one.
  std::string Open(const std::string& fileName);

  /// Moves to the next line that holds a word beside comments (from # on); false at the end.
  bool NextLine();

  /// The words of the current line.
  const std::vector<std::string_view>& Words() const { return this->Line; }
  int LineNumber() const { return this->Number; }
  std::size_t Size() const { return this->Text.size(); }
  double FractionRead() const
  {
    return this->Text.empty() ? 1.0 : static_cast<double>(this->Position) / this->Text.size();
  }

private:
  std::string Text;
  std::size_t Position = 0;
  std::vector<std::string_view> Line;
  int Number = 0;
};

/// The whole word as a number; false if it is none or out of range.
bool ToNumber(std::string_view word, double& value);
bool ToNumber(std::string_view word, int& value);
}

#endif
