// SPDX-License-Identifier: BSD-3-Clause
#include "TransferCommand.h"

#include "CommandError.h"
#include "Console.h"
#include "MeshFiles.h"

#include <vtkMSPSkeleton.h>
#include <vtkMarrowSegmentCutter.h>
#include <vtkPolyData.h>
#include <vtkSegmentationTransfer.h>

#include <filesystem>
#include <map>

CLI::App* TransferCommand::Declare(CLI::App& marrow)
{
  CLI::App* app =
    marrow.add_subcommand("transfer", "Carry the segments of a source mesh to target meshes");
  app->add_option("source", this->Source, "Source mesh")->required();
  app->add_option("targets", this->Targets, "Target meshes")->required();
  app->add_option("--segments", this->Segments.File,
    "Segments of the source: a .seg file, one integer per face, or a mesh of the same faces; "
    "without it the source holds them itself");
  app->add_option("--labels", this->Segments.Labels, files::LabelsHelp)->capture_default_str();
  app
    ->add_option("-o,--output", this->Output,
      "For one target a file (.vtp .vtk .ply .obj .off .seg), for several a folder")
    ->required();
  app->add_option("--format", this->Format, "What to write into the folder")
    ->check(CLI::IsMember(files::Formats()))
    ->capture_default_str();
  this->Hints.Declare(*app);
  app
    ->add_option("--answer", this->AnswerIndex,
      "Which answer to how the skeletons match is taken: 0 the likeliest, 1 the next, and so on")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  app
    ->add_option("--only", this->Carried,
      "The segments to carry, with commas between them; faces that would get another get -1")
    ->delimiter(',');
  app->add_flag("--keep", this->Keep,
    "Keep the segments that a target has already, where they are not -1: those of the file "
    "TARGET.seg "
    "beside it, else its own");
  app->add_flag("--cut", this->Cut,
    "Cut the target's faces along smooth boundaries of the segments; without it whole faces are "
    "labelled");
  app->add_flag("--skeletons", this->WriteSkeletons,
    "Also write the skeletons, NAME_skeleton.vtp in the folder of the output");
  app->footer(
    "Examples:\n"
    "  marrow transfer camel.off cow.off --segments camel.seg -o cow.vtp\n"
    "  marrow transfer camel.off cow.off bull.off --segments camel.seg -o labelled\n"
    "  marrow transfer camel.off cow.off --segments camel.seg -o cow.obj\n"
    "  marrow transfer camel.off cow.off --segments camel.seg --hint 740:71 -o cow.vtp\n"
    "A target that cannot be done is named, and the others are done; the exit code is then 1.");
  return app;
}

std::vector<std::string> TransferCommand::OutputFiles() const
{
  if (this->Targets.size() == 1 && !files::Extension(this->Output).empty())
  {
    files::RequireExtension(this->Output, files::WritableMeshes());
    return { this->Output };
  }
  files::MakeFolder(this->Output);
  std::vector<std::string> outputs;
  for (const std::string& target : this->Targets)
  {
    outputs.push_back(
      (std::filesystem::path(this->Output) / (files::Stem(target) + "." + this->Format)).string());
  }
  return outputs;
}

void TransferCommand::RequireFreeNames(const std::vector<std::string>& outputs) const
{
  std::map<std::string, std::string> meshOfOutput;
  const auto require = [&meshOfOutput](const std::string& output, const std::string& mesh)
  {
    const auto [other, isFree] = meshOfOutput.emplace(output, mesh);
    if (!isFree)
    {
      throw CommandError(mesh + ": what comes of it and of " + other->second +
        " would both be written to " + output + "; rename one or run them apart.");
    }
    files::RequireWritable(output);
  };
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    require(outputs[i], this->Targets[i]);
  }
  if (this->WriteSkeletons)
  {
    require(this->SkeletonFile(this->Source, outputs.front()), this->Source);
    for (std::size_t i = 0; i < outputs.size(); ++i)
    {
      require(this->SkeletonFile(this->Targets[i], outputs[i]), this->Targets[i]);
    }
  }
}

std::string TransferCommand::SkeletonFile(
  const std::string& mesh, const std::string& besideFile) const
{
  const std::filesystem::path folder = std::filesystem::path(besideFile).parent_path();
  return (folder / (files::Stem(mesh) + "_skeleton.vtp")).string();
}

vtkSmartPointer<vtkPolyData> TransferCommand::WithSkeleton(
  vtkPolyData* mesh, const std::string& path, const std::string& besideFile, Console& console) const
{
  if (!this->WriteSkeletons)
  {
    return mesh;
  }
  vtkNew<vtkMSPSkeleton> skeleton;
  skeleton->SetInputData(mesh);
  console.Update(skeleton, path);
  files::Write(vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(0)),
    this->SkeletonFile(path, besideFile), console);
  return vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(1));
}

void TransferCommand::SetUp(vtkSegmentationTransfer* transfer) const
{
  transfer->SetAnswerIndex(this->AnswerIndex);
  transfer->SetKeepTargetSegments(this->Keep);
  for (const int segment : this->Carried)
  {
    transfer->AddCarriedSegment(segment);
  }
}

vtkSmartPointer<vtkPolyData> TransferCommand::ReadTarget(
  const std::string& path, Console& console) const
{
  if (!this->Keep)
  {
    return files::ReadMesh(path, console);
  }
  const std::filesystem::path beside =
    std::filesystem::path(path).parent_path() / (files::Stem(path) + ".seg");
  files::SegmentSource segments = this->Segments;
  segments.File = std::filesystem::exists(beside) ? beside.string() : "";
  return files::ReadSegmented(path, segments, console);
}

void TransferCommand::TransferTo(vtkSegmentationTransfer* transfer, const std::string& target,
  const std::string& output, Console& console) const
{
  const vtkSmartPointer<vtkPolyData> mesh = this->ReadTarget(target, console);
  transfer->SetInputData(1, this->WithSkeleton(mesh, target, output, console));
  if (!this->Hints.IsEmpty())
  {
    auto* source = vtkPolyData::SafeDownCast(transfer->GetInputDataObject(0, 0));
    this->Hints.Connect(transfer, { 4, source, this->Source }, { 5, mesh, target });
  }
  console.Update(transfer, target);
  vtkSmartPointer<vtkPolyData> labelled =
    vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(0));
  files::ShowNote(labelled, target, console);
  if (this->Cut)
  {
    vtkNew<vtkMarrowSegmentCutter> cutter;
    cutter->SetInputData(labelled);
    console.Update(cutter, target);
    labelled = cutter->GetOutput();
  }
  files::Write(labelled, output, console);
}

void TransferCommand::Run(Console& console)
{
  const std::vector<std::string> outputs = this->OutputFiles();
  if (this->Cut && files::Extension(outputs.front()) == ".seg")
  {
    throw CommandError(outputs.front() +
      ": a .seg file is of the target's own faces, which --cut cuts; choose a format of meshes.");
  }
  this->RequireFreeNames(outputs);
  // One filter for all targets: what it knows of the source is found out once.
  vtkNew<vtkSegmentationTransfer> transfer;
  this->SetUp(transfer);
  transfer->SetInputData(0,
    this->WithSkeleton(files::ReadSegmented(this->Source, this->Segments, console), this->Source,
      outputs.front(), console));

  std::vector<std::string> failed;
  for (std::size_t i = 0; i < this->Targets.size(); ++i)
  {
    try
    {
      this->TransferTo(transfer, this->Targets[i], outputs[i], console);
    }
    catch (const std::exception& error)
    {
      if (this->Targets.size() == 1)
      {
        throw;
      }
      console.ShowError(error);
      failed.push_back(this->Targets[i]);
    }
  }
  files::ShowNote(transfer->GetOutputDataObject(1), this->Source, console);
  if (!failed.empty())
  {
    std::string names;
    for (const std::string& name : failed)
    {
      names += (names.empty() ? "" : ", ") + name;
    }
    throw CommandError(std::to_string(this->Targets.size() - failed.size()) + " of " +
      std::to_string(this->Targets.size()) + " done; " + std::to_string(failed.size()) +
      " failed: " + names);
  }
}
