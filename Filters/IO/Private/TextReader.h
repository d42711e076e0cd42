// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TextReader_h
#define marrow_TextReader_h

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace marrow
{
/// Goes through text line by line: any line ends, a byte order mark at the beginning, no line end at
/// the last one. The words are views on the text, which must outlive them.
class TextReader
{
public:
  /// What a format makes of two characters.
  enum class Style
  {
    Comments,  ///< # begins a comment anywhere
    WaveFront, ///< # begins a comment before a word; \ at the end of a line continues it
    Plain      ///< neither
  };

  explicit TextReader(std::string_view text, Style style = Style::Comments);

  /// Moves to the next line that holds a word; false at the end.
  bool NextLine();

  /// The words of the current line.
  const std::vector<std::string_view>& Words() const { return this->Line; }
  /// Of the current line, from 1; of its first part where it is continued.
  int LineNumber() const { return this->Number; }
  std::size_t Size() const { return this->Text.size(); }
  double FractionRead() const
  {
    return this->Text.empty() ? 1.0 : static_cast<double>(this->Position) / this->Text.size();
  }
  /// Of the first byte behind the current line.
  std::size_t BytesRead() const { return this->Position; }

private:
  std::size_t LineEndAt(std::size_t position) const;
  bool IsContinuedAt(std::size_t position) const;

  std::string_view Text;
  Style Rules;
  std::size_t Position = 0;
  std::vector<std::string_view> Line;
  int Number = 0;
  int LinesRead = 0;
};

/// The whole word as a number; false if it is none or an integer out of range. Too large a real number
/// is infinite, too small a one zero.
bool ToNumber(std::string_view word, double& value);
bool ToNumber(std::string_view word, int& value);
bool ToNumber(std::string_view word, std::int64_t& value);

/// A word as a message can show it: shortened, and never bytes that are not text.
std::string Quoted(std::string_view word);
}

#endif
