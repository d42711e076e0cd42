// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionCommand_h
#define marrow_CollectionCommand_h

#include "CollectionFolder.h"
#include "Command.h"

#include <string>
#include <vector>

class vtkCollectionTransfer;
class vtkPolyData;

/// `marrow collection`: labels all meshes of a folder from those that are labelled (vtkCollectionTransfer).
class CollectionCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& marrow) override;
  void Run(Console& console) override;

private:
  /// Throws CommandError unless what is to be written can be.
  void RequireOutput() const;

  /// The meshes of the output, per entry; null for what was not used.
  std::vector<vtkPolyData*> Label(vtkCollectionTransfer* transfer,
    const std::vector<CollectionEntry>& entries, Console& console) const;

  std::string Folder;
  std::string Output;
  std::string Format = "vtp";
  std::string Labels;
  std::string Report;
  bool IsVoteAlone = false;
};

#endif
