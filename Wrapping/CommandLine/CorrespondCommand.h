// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CorrespondCommand_h
#define marrow_CorrespondCommand_h

#include "Command.h"
#include "HintOptions.h"

#include <string>
#include <vector>

/// `marrow correspond`: which parts of two skeletons match (vtkSkeletonCorrespondence).
class CorrespondCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& marrow) override;
  void Run(Console& console) override;

private:
  std::string Source;
  std::string Target;
  std::string Output;
  std::string Matcher = "tree";
  HintOptions Hints;
  std::vector<std::string> Skeletons;
};

#endif
