// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorRecorder.h"

#include <vtkObjectFactory.h>

#include <iostream>

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
  return sentence;
}
}

vtkStandardNewMacro(ErrorRecorder);

void ErrorRecorder::DisplayErrorText(const char* text)
{
  if (this->FirstError.empty())
  {
    this->FirstError = Sentence(text);
  }
}

void ErrorRecorder::DisplayWarningText(const char* text)
{
  if (!this->Quiet)
  {
    std::cerr << "marrow: warning: " << Sentence(text) << std::endl;
  }
}

void ErrorRecorder::DisplayGenericWarningText(const char* text)
{
  this->DisplayWarningText(text);
}
