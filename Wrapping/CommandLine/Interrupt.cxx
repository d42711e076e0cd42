// SPDX-License-Identifier: BSD-3-Clause
#include "Interrupt.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

#include <csignal>

namespace
{
volatile std::sig_atomic_t isAsked = 0;

void Ask(int signal)
{
  isAsked = 1;
  std::signal(signal, SIG_DFL);
}

void AbortIfAsked(vtkObject* caller, unsigned long, void*, void*)
{
  if (isAsked)
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
}
}

Interrupt::Interrupt(vtkAlgorithm* algorithm)
  : Algorithm(algorithm)
{
  isAsked = 0;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(AbortIfAsked);
  this->Observer = algorithm->AddObserver(vtkCommand::ProgressEvent, abort);
  this->Before = std::signal(SIGINT, Ask);
}

Interrupt::~Interrupt()
{
  std::signal(SIGINT, this->Before);
  this->Algorithm->RemoveObserver(this->Observer);
}

bool Interrupt::IsAsked() const
{
  return isAsked != 0;
}
