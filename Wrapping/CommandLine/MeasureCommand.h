// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeasureCommand_h
#define marrow_MeasureCommand_h

#include "Command.h"

#include <string>

/// `marrow measure`: AGD, MSP and the other measures on a mesh (vtkMSPField).
class MeasureCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& marrow) override;
  void Run(Console& console) override;

private:
  std::string Mesh;
  std::string Output;
  int MaximumFaces = 0;
};

#endif
