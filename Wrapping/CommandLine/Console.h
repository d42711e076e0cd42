// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Console_h
#define marrow_Console_h

#include <vtkNew.h>

#include <exception>
#include <string>

class ErrorRecorder;
class vtkAlgorithm;

/// The program's voice: a progress bar on a terminal, warnings on stderr, and VTK's errors turned
/// into CommandError instead of dumps.
///
/// While a Console lives it is VTK's output window, so errors of every VTK object are caught, those
/// inside of filters too.
class Console
{
public:
  Console();
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// No progress bar and no warnings. Errors are told in any case.
  void SetQuiet(bool quiet);

  /// Runs a filter, reader or writer with a progress bar titled `title`; throws CommandError with
  /// the first error that any VTK object reported meanwhile.
  void Update(vtkAlgorithm* algorithm, const std::string& title);

  /// Throws CommandError if a VTK object has reported an error since the last call. For classes
  /// that are no algorithms or whose work begins elsewhere than in Update(), such as writers.
  void ThrowIfError(const std::string& title);

  /// Tells what was done to the file beside its task, unless quiet.
  void ShowNote(const std::string& title, const std::string& text) const;

  /// Tells of what ends the program, or one of many tasks.
  static void ShowError(const std::exception& error);

private:
  vtkNew<ErrorRecorder> Recorder;
  bool Quiet = false;
};

#endif
