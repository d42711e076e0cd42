// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Command_h
#define marrow_Command_h

#include <CLI/CLI.hpp>

class Console;

/// A subcommand of `marrow`: declares its arguments, and runs once they are parsed.
class Command
{
public:
  virtual ~Command() = default;

  /// Adds the subcommand with its arguments, help and example, and returns it.
  virtual CLI::App* Declare(CLI::App& marrow) = 0;

  /// Does the work. Throws CommandError when something is wrong.
  virtual void Run(Console& console) = 0;
};

#endif
