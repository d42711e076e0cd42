// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
struct Messages
{
  std::string FirstError;
  int NumberOfWarnings = 0;

  static void Collect(vtkObject*, unsigned long event, void* clientData, void* text)
  {
    auto* messages = static_cast<Messages*>(clientData);
    if (event == vtkCommand::WarningEvent)
    {
      ++messages->NumberOfWarnings;
    }
    else if (messages->FirstError.empty())
    {
      messages->FirstError = static_cast<const char*>(text);
    }
  }
};
}

double Run(vtkAlgorithm* filter, int* numberOfWarnings)
{
  Messages messages;
  vtkNew<vtkCallbackCommand> collect;
  collect->SetCallback(Messages::Collect);
  collect->SetClientData(&messages);
  filter->AddObserver(vtkCommand::ErrorEvent, collect);
  filter->AddObserver(vtkCommand::WarningEvent, collect);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collect);

  const auto begin = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;

  filter->RemoveObserver(collect);
  filter->GetExecutive()->RemoveObserver(collect);
  if (numberOfWarnings)
  {
    *numberOfWarnings = messages.NumberOfWarnings;
  }
  if (!messages.FirstError.empty())
  {
    // VTK writes "ERROR: In file, line N\nClass (address): sentence\n\n".
    std::string& text = messages.FirstError;
    const std::size_t sentence = text.find("): ");
    text.erase(0, sentence == std::string::npos ? 0 : sentence + 3);
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw std::runtime_error(text);
  }
  return seconds.count();
}
}
