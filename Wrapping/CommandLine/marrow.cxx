// SPDX-License-Identifier: BSD-3-Clause
// The `marrow` command: one subcommand per stage of the pipeline, and one that draws.
#include "CollectionCommand.h"
#include "CommandError.h"
#include "Console.h"
#include "CorrespondCommand.h"
#include "EvaluateCommand.h"
#include "MeasureCommand.h"
#include "RenderCommand.h"
#include "SkeletonCommand.h"
#include "TransferCommand.h"

#include <vtkSMPTools.h>

#include <CLI/CLI.hpp>

#include <iostream>

namespace
{
int Run(int argc, char** argv)
{
  CLI::App app{ "Skeleton-driven segmentation transfer between triangle meshes" };
  app.name("marrow");
  app.set_version_flag("--version", MARROW_VERSION);
  app.require_subcommand(1);
  // Lets --quiet and --threads stand behind the subcommand too.
  app.fallthrough();
  app.failure_message([](const CLI::App*, const CLI::Error& error)
    { return std::string("marrow: ") + error.what() + "; see marrow --help.\n"; });
  bool quiet = false;
  app.add_flag("-q,--quiet", quiet, "No progress bar and no warnings");
  int threads = 0;
  app.add_option("--threads", threads, "Number of threads (default: all processors)")
    ->check(CLI::Range(1, 1024));

  MeasureCommand measure;
  SkeletonCommand skeleton;
  CorrespondCommand correspond;
  TransferCommand transfer;
  CollectionCommand collection;
  EvaluateCommand evaluate;
  RenderCommand render;
  const std::pair<CLI::App*, Command*> commands[] = { { measure.Declare(app), &measure },
    { skeleton.Declare(app), &skeleton }, { correspond.Declare(app), &correspond },
    { transfer.Declare(app), &transfer }, { collection.Declare(app), &collection },
    { evaluate.Declare(app), &evaluate }, { render.Declare(app), &render } };
  CLI11_PARSE(app, argc, argv);

  Console console;
  console.SetQuiet(quiet);
  if (threads > 0)
  {
    vtkSMPTools::Initialize(threads);
  }
  for (const auto& [parsed, command] : commands)
  {
    if (*parsed)
    {
      command->Run(console);
    }
  }
  // A full disk may show only now.
  if (!std::cout.flush())
  {
    throw CommandError(
      "The results cannot be written to the standard output: check the space left.");
  }
  return EXIT_SUCCESS;
}
}

int main(int argc, char** argv)
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::exception& error)
  {
    Console::ShowError(error);
    return EXIT_FAILURE;
  }
}
