// SPDX-License-Identifier: BSD-3-Clause
#include "Processes.h"

#include <vtkMultiProcessController.h>
#ifdef MARROW_COMMAND_MPI
#include <vtkMPIController.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <exception>

#ifdef MARROW_COMMAND_MPI
namespace
{
/// MPI takes a while to begin with, and is of no use to a process alone. What Open MPI, MPICH and its
/// relatives, and Slurm set for the processes that they start.
bool IsStartedByMPI()
{
  const char* const variables[] = { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK" };
  return std::any_of(std::begin(variables), std::end(variables),
    [](const char* variable) { return std::getenv(variable) != nullptr; });
}
}
#endif

Processes::Processes()
{
#ifdef MARROW_COMMAND_MPI
  if (IsStartedByMPI())
  {
    this->Controller = vtkSmartPointer<vtkMPIController>::New();
    this->Controller->Initialize(nullptr, nullptr);
  }
#endif
}

Processes::~Processes()
{
  if (this->Controller && std::uncaught_exceptions() == 0)
  {
    this->Controller->Finalize();
  }
}

vtkMultiProcessController* Processes::GetController() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1 ? this->Controller.Get()
                                                                          : nullptr;
}

bool Processes::IsFirst() const
{
  return !this->Controller || this->Controller->GetLocalProcessId() == 0;
}
