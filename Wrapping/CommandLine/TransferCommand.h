// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TransferCommand_h
#define marrow_TransferCommand_h

#include "Command.h"
#include "HintOptions.h"
#include "MeshFiles.h"

#include <string>
#include <vector>

class vtkSegmentationTransfer;

/// `marrow transfer`: carries the segments of one mesh to others (vtkSegmentationTransfer).
class TransferCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& marrow) override;
  void Run(Console& console) override;

private:
  /// The file to write for each target.
  std::vector<std::string> OutputFiles() const;

  /// Throws CommandError unless all files can be written, each for one mesh only.
  void RequireFreeNames(const std::vector<std::string>& outputs) const;

  std::string SkeletonFile(const std::string& mesh, const std::string& besideFile) const;

  /// With --skeletons: writes the mesh's skeleton, and returns the mesh with its measures.
  vtkSmartPointer<vtkPolyData> WithSkeleton(vtkPolyData* mesh, const std::string& path,
    const std::string& besideFile, Console& console) const;

  void SetUp(vtkSegmentationTransfer* transfer) const;

  /// The target, with --keep with its segments.
  vtkSmartPointer<vtkPolyData> ReadTarget(const std::string& path, Console& console) const;

  void TransferTo(vtkSegmentationTransfer* transfer, const std::string& target,
    const std::string& output, Console& console) const;

  std::string Source;
  std::vector<std::string> Targets;
  files::SegmentSource Segments;
  std::string Output;
  std::string Format = "vtp";
  HintOptions Hints;
  int AnswerIndex = 0;
  std::vector<int> Carried;
  bool Keep = false;
  bool Cut = false;
  bool WriteSkeletons = false;
};

#endif
