// SPDX-License-Identifier: BSD-3-Clause
#include "VTKMessages.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <cctype>

namespace marrow
{
class MessageRecorder : public vtkOutputWindow
{
public:
  static MessageRecorder* New();
  vtkTypeMacro(MessageRecorder, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    if (this->First.empty())
    {
      this->First = text;
    }
  }

  std::string First;

protected:
  MessageRecorder() = default;
};

vtkStandardNewMacro(MessageRecorder);

VTKMessages::VTKMessages()
  : UsersWindow(vtkOutputWindow::GetInstance())
  , UsersVerbosity(vtkLogger::GetCurrentVerbosityCutoff())
{
  vtkOutputWindow::SetInstance(this->Recorder);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VTKMessages::~VTKMessages()
{
  vtkLogger::SetStderrVerbosity(this->UsersVerbosity);
  vtkOutputWindow::SetInstance(this->UsersWindow);
}

/// VTK writes "ERROR: In FILE, line N\nvtkClass (0x...): SENTENCE\n\n".
std::string VTKMessages::FirstError() const
{
  std::string text = this->Recorder->First;
  text.erase(0, text.find('\n') + 1);
  const std::string::size_type object = text.find("): ");
  text.erase(0, object == std::string::npos ? 0 : object + 3);
  while (
    !text.empty() && (std::isspace(static_cast<unsigned char>(text.back())) || text.back() == '.'))
  {
    text.pop_back();
  }
  for (char& c : text)
  {
    c = std::isspace(static_cast<unsigned char>(c)) ? ' ' : c;
  }
  return text;
}
}
