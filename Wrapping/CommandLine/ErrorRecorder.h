// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ErrorRecorder_h
#define marrow_ErrorRecorder_h

#include <vtkOutputWindow.h>

#include <string>

/// An output window that keeps the first error and prints warnings as one line each.
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

  bool Quiet = false;
  /// The sentence of the first error since it was last cleared: an error that follows is most often
  /// a consequence, as when the pipeline reports that a filter failed.
  std::string FirstError;

protected:
  ErrorRecorder() = default;
};

#endif
