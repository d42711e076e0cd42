// SPDX-License-Identifier: BSD-3-Clause
#include "TransferCommand.h"

#include "CommandError.h"
#include "Console.h"
#include "MeshFiles.h"

#include <vtkCellData.h>
#include <vtkMSPSkeleton.h>
#include <vtkPolyData.h>
#include <vtkSegmentationTransfer.h>

#include <algorithm>
#include <filesystem>

CLI::App* TransferCommand::Declare(CLI::App& marrow)
{
  CLI::App* app =
    marrow.add_subcommand("transfer", "Carry the segments of a source mesh to target meshes");
  app->add_option("source", this->Source, "Source mesh")->required();
  app->add_option("targets", this->Targets, "Target meshes")->required();
  app->add_option("--segments", this->Segments,
    "Segments of the source: a .seg file, one integer per face; without it the source must hold "
    "the cell array SegmentId");
  app
    ->add_option(
      "-o,--output", this->Output, "For one target a file (.seg .vtp .vtk), for several a folder")
    ->required();
  app->add_option("--format", this->Format, "What to write into the folder")
    ->check(CLI::IsMember({ "seg", "vtp" }))
    ->capture_default_str();
  app->add_flag("--skeletons", this->WriteSkeletons,
    "Also write the skeletons, NAME_skeleton.vtp in the folder of the output");
  app->footer("Examples:\n"
              "  marrow transfer camel.off cow.off --segments camel.seg -o cow.vtp\n"
              "  marrow transfer camel.off cow.off bull.off --segments camel.seg -o labelled");
  return app;
}

std::vector<std::string> TransferCommand::OutputFiles() const
{
  if (this->Targets.size() == 1 && !files::Extension(this->Output).empty())
  {
    files::RequireExtension(this->Output, { ".seg", ".vtp", ".vtk" });
    return { this->Output };
  }
  std::vector<std::string> outputs;
  for (const std::string& target : this->Targets)
  {
    outputs.push_back(
      (std::filesystem::path(this->Output) / (files::Stem(target) + "." + this->Format)).string());
    if (std::count(outputs.begin(), outputs.end(), outputs.back()) > 1)
    {
      throw CommandError(target + ": two targets of that name would both be written to " +
        outputs.back() + "; rename one or run them apart.");
    }
  }
  files::MakeFolder(this->Output);
  return outputs;
}

void TransferCommand::WriteSkeleton(vtkMSPSkeleton* skeleton, const std::string& mesh,
  const std::string& besideFile, Console& console) const
{
  if (this->WriteSkeletons)
  {
    const std::filesystem::path folder = std::filesystem::path(besideFile).parent_path();
    files::WritePolyData(vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(0)),
      (folder / (files::Stem(mesh) + "_skeleton.vtp")).string(), console);
  }
}

void TransferCommand::Run(Console& console)
{
  const std::vector<std::string> outputs = this->OutputFiles();
  vtkSmartPointer<vtkPolyData> source = files::ReadMesh(this->Source, console);
  if (!this->Segments.empty())
  {
    source = files::ReadSegments(source, this->Segments, console);
  }
  else if (!source->GetCellData()->HasArray("SegmentId"))
  {
    throw CommandError(
      this->Source + ": the mesh has no cell array SegmentId; name a .seg file with --segments.");
  }

  // Once for all targets.
  vtkNew<vtkMSPSkeleton> sourceSkeleton;
  sourceSkeleton->SetInputData(source);
  console.Update(sourceSkeleton, this->Source);
  this->WriteSkeleton(sourceSkeleton, this->Source, outputs.front(), console);

  for (std::size_t i = 0; i < this->Targets.size(); ++i)
  {
    vtkNew<vtkMSPSkeleton> targetSkeleton;
    targetSkeleton->SetInputData(files::ReadMesh(this->Targets[i], console));
    console.Update(targetSkeleton, this->Targets[i]);
    this->WriteSkeleton(targetSkeleton, this->Targets[i], outputs[i], console);

    vtkNew<vtkSegmentationTransfer> transfer;
    transfer->SetInputConnection(0, sourceSkeleton->GetOutputPort(1));
    transfer->SetInputConnection(1, targetSkeleton->GetOutputPort(1));
    transfer->SetInputConnection(2, sourceSkeleton->GetOutputPort(0));
    transfer->SetInputConnection(3, targetSkeleton->GetOutputPort(0));
    console.Update(transfer, this->Targets[i]);

    auto* labelled = vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(0));
    if (files::Extension(outputs[i]) == ".seg")
    {
      files::WriteSegments(labelled, outputs[i], console);
    }
    else
    {
      files::WritePolyData(labelled, outputs[i], console);
    }
  }
}
