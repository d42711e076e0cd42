// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonCommand_h
#define marrow_SkeletonCommand_h

#include "Command.h"

#include <string>

/// `marrow skeleton`: the skeleton of a mesh (vtkMSPSkeleton).
class SkeletonCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& marrow) override;
  void Run(Console& console) override;

private:
  std::string Mesh;
  std::string Output;
  std::string MeshOutput;
};

#endif
