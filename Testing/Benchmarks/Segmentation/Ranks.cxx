// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks.h"

#include <vtkDummyController.h>
#include <vtkPolyData.h>
#ifdef MARROW_BENCHMARK_MPI
#include <vtkMPIController.h>
#endif

namespace marrow::bench
{
Ranks::Ranks(int* argc, char*** argv)
{
#ifdef MARROW_BENCHMARK_MPI
  this->Controller = vtkSmartPointer<vtkMPIController>::New();
#else
  this->Controller = vtkSmartPointer<vtkDummyController>::New();
#endif
  this->Controller->Initialize(argc, argv);
}

Ranks::~Ranks()
{
  this->Controller->Finalize();
}

int Ranks::Rank() const
{
  return this->Controller->GetLocalProcessId();
}

int Ranks::Size() const
{
  return this->Controller->GetNumberOfProcesses();
}

void Ranks::Broadcast(vtkPolyData* data, int root)
{
  if (this->Size() > 1)
  {
    this->Controller->Broadcast(data, root);
  }
}

void Ranks::Broadcast(double* values, int size, int root)
{
  if (this->Size() > 1)
  {
    this->Controller->Broadcast(values, size, root);
  }
}

void Ranks::Broadcast(std::string& text, int root)
{
  if (this->Size() > 1)
  {
    vtkIdType size = static_cast<vtkIdType>(text.size());
    this->Controller->Broadcast(&size, 1, root);
    text.resize(size);
    this->Controller->Broadcast(&text[0], size, root);
  }
}

void Ranks::Barrier()
{
  this->Controller->Barrier();
}
}
