// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorRecorder.h"

#include <vtkObjectFactory.h>

#include <cctype>

namespace
{
/// VTK writes "ERROR: In FILE, line N\nvtkClass (0x...): SENTENCE\n\n": the user needs SENTENCE.
std::string Sentence(const std::string& text)
{
  std::string::size_type begin = text.find('\n');
  begin = begin == std::string::npos ? 0 : begin + 1;
  const std::string::size_type object = text.find("): ", begin);
  if (object != std::string::npos)
  {
    begin = object + 3;
  }
  std::string sentence = text.substr(begin);
  while (!sentence.empty() && std::isspace(static_cast<unsigned char>(sentence.back())))
  {
    sentence.pop_back();
  }
  for (char& c : sentence)
  {
    c = c == '\n' ? ' ' : c;
  }
  if (!sentence.empty() && sentence.back() != '.')
  {
    sentence += '.';
  }
  return sentence;
}
}

vtkStandardNewMacro(ErrorRecorder);

void ErrorRecorder::DisplayErrorText(const char* text)
{
  if (!this->FirstError.empty())
  {
    return;
  }
  this->FirstError = Sentence(text);
  if (this->FirstError.find("returned failure for request") != std::string::npos)
  {
    // The pipeline's word on an algorithm that gave no reason, or called it a warning.
    this->FirstError = this->Warnings.empty() ? "It cannot be processed." : this->Warnings.back();
  }
}

void ErrorRecorder::DisplayWarningText(const char* text)
{
  this->Warnings.push_back(Sentence(text));
}

void ErrorRecorder::DisplayGenericWarningText(const char* text)
{
  this->DisplayWarningText(text);
}
