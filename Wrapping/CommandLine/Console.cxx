// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"

#include "CommandError.h"
#include "ErrorRecorder.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkLogger.h>

#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace
{
constexpr int WidthOfBar = 30;

/// Rewrites one line of the terminal.
void DrawBar(vtkObject* caller, unsigned long, void* title, void*)
{
  const double done = static_cast<vtkAlgorithm*>(caller)->GetProgress();
  std::fprintf(stderr, "\r%-32.32s [", static_cast<const std::string*>(title)->c_str());
  for (int i = 0; i < WidthOfBar; ++i)
  {
    std::fputc(i < done * WidthOfBar ? '#' : '-', stderr);
  }
  std::fprintf(stderr, "] %3.0f %%", 100 * done);
}

void EraseBar()
{
  std::fprintf(stderr, "\r\033[K");
}
}

Console::Console()
{
  vtkOutputWindow::SetInstance(this->Recorder);
  // VTK logs every error and warning to stderr too.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

Console::~Console()
{
  vtkOutputWindow::SetInstance(nullptr);
}

void Console::SetQuiet(bool quiet)
{
  this->Quiet = quiet;
}

void Console::Update(vtkAlgorithm* algorithm, const std::string& title)
{
  const bool bar = !this->Quiet && isatty(STDERR_FILENO);
  std::string shown = title;
  vtkNew<vtkCallbackCommand> draw;
  draw->SetCallback(DrawBar);
  draw->SetClientData(&shown);
  unsigned long observer = 0;
  if (bar)
  {
    observer = algorithm->AddObserver(vtkCommand::ProgressEvent, draw);
  }
  algorithm->Update();
  if (bar)
  {
    algorithm->RemoveObserver(observer);
    EraseBar();
  }
  this->ThrowIfError(title);
}

void Console::ThrowIfError(const std::string& title)
{
  std::string error;
  error.swap(this->Recorder->FirstError);
  std::vector<std::string> warnings;
  warnings.swap(this->Recorder->Warnings);
  if (!error.empty())
  {
    const bool isNamed = error.find(title) != std::string::npos;
    throw CommandError(isNamed ? error : title + ": " + error);
  }
  for (const std::string& warning : warnings)
  {
    if (!this->Quiet)
    {
      std::cerr << "marrow: warning: " << title << ": " << warning << std::endl;
    }
  }
}

void Console::ShowError(const std::exception& error)
{
  std::cerr << "marrow: " << error.what() << std::endl;
}

void Console::ShowNote(const std::string& title, const std::string& text) const
{
  if (!this->Quiet)
  {
    std::cerr << "marrow: note: " << title << ": " << text << "." << std::endl;
  }
}
