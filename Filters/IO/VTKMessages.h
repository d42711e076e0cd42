// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_VTKMessages_h
#define marrow_VTKMessages_h

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkOutputWindow;

namespace marrow
{
class MessageRecorder;

/// While one lives, VTK's errors and warnings are kept instead of shown: VTK's readers tell of one
/// defect in several, some of them from objects that nobody else can watch.
class VTKMessages
{
public:
  VTKMessages();
  ~VTKMessages();
  VTKMessages(const VTKMessages&) = delete;
  VTKMessages& operator=(const VTKMessages&) = delete;

  /// The first error as a clause without full stop; empty if there was none.
  std::string FirstError() const;

private:
  vtkNew<MessageRecorder> Recorder;
  vtkSmartPointer<vtkOutputWindow> UsersWindow;
  vtkLogger::Verbosity UsersVerbosity;
};
}

#endif
