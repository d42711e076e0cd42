// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ErrorRecorder_h
#define marrow_ErrorRecorder_h

#include <vtkOutputWindow.h>

#include <string>
#include <vector>

/// An output window that keeps what it is told, as plain sentences.
class ErrorRecorder : public vtkOutputWindow
{
public:
  static ErrorRecorder* New();
  vtkTypeMacro(ErrorRecorder, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;

  /// The first error: those that follow are most often its consequences.
  std::string FirstError;
  std::vector<std::string> Warnings;

protected:
  ErrorRecorder() = default;
};

#endif
