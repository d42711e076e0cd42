// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Processes_h
#define marrow_Processes_h

#include <vtkSmartPointer.h>

class vtkMultiProcessController;

/// The processes that mpiexec started, through VTK's MPI controller; this one alone where the program was
/// started without it or built without VTK::ParallelMPI.
class Processes
{
public:
  Processes();
  /// Ends MPI, but not on an exception: then mpiexec ends all, as none is to wait for one that failed.
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// Null for one alone.
  vtkMultiProcessController* GetController() const;
  bool IsFirst() const;

private:
  vtkSmartPointer<vtkMultiProcessController> Controller;
};

#endif
