// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionCommand.h"

#include "CollectionReport.h"
#include "CollectionSummary.h"
#include "CommandError.h"
#include "Console.h"
#include "Interrupt.h"
#include "MeshFiles.h"
#include "Processes.h"

#include <vtkCellData.h>
#include <vtkCollectionTransfer.h>
#include <vtkCompositeDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace
{
/// The rejected answers are the report's alone: what is written does not depend on whether there is one.
vtkSmartPointer<vtkPolyData> WithoutRejected(vtkPolyData* mesh)
{
  auto written = vtkSmartPointer<vtkPolyData>::New();
  written->ShallowCopy(mesh);
  written->GetCellData()->RemoveArray("RejectedSegmentId");
  written->GetFieldData()->RemoveArray("RejectedAgainst");
  written->GetFieldData()->RemoveArray("RejectedDifference");
  return written;
}
}

CLI::App* CollectionCommand::Declare(CLI::App& marrow)
{
  CLI::App* app = marrow.add_subcommand(
    "collection", "Label all meshes of a folder from those of them that are labelled");
  app
    ->add_option("folder", this->Folder,
      "Folder of meshes of one kind. One with NAME.seg beside it, or with segments of its own, is "
      "labelled; equal numbers are equal segments on all of them")
    ->required()
    ->check(CLI::ExistingDirectory);
  app
    ->add_option("-o,--output", this->Output,
      "Folder for what was labelled, for summary.csv and summary.json, and for what another run "
      "can use")
    ->required();
  app->add_option("--format", this->Format, "What to write for each mesh")
    ->check(CLI::IsMember(files::Formats()))
    ->capture_default_str();
  app->add_option("--labels", this->Labels,
    std::string(files::LabelsHelp) + " (default: the array SegmentId, where it is)");
  app->add_flag("--no-learning", this->IsVoteAlone,
    "Label by the vote of the meshes alone; else, with three labelled ones or more, what is learnt "
    "from them counts as far as it does well on each of them when its labels are held back");
  app->add_option("--report", this->Report,
    "A page (.html) to look through the result, the least sure first; needs an X display");
  app->footer(
    "Examples:\n"
    "  marrow collection animals -o labelled\n"
    "  marrow collection animals -o labelled --format seg\n"
    "To correct one, put its corrected NAME.seg beside it and run again: only what "
    "depends on it is done "
    "anew. Ctrl-C loses nothing that is done. A mesh that cannot be used is named, and "
    "the others are "
    "done; the exit code is then 1.\n"
    "After mpiexec several processes share the work; both folders have to be the same for all, "
    "as on a file system that several machines share.");
  return app;
}

void CollectionCommand::RequireOutput() const
{
  files::MakeFolder(this->Output);
  if (fs::equivalent(this->Folder, this->Output))
  {
    throw CommandError(this->Output +
      ": what is written there would be taken for labelled by the next run; choose another "
      "folder.");
  }
  files::RequireWritable((fs::path(this->Output) / "summary.csv").string());
  if (this->Report.empty())
  {
    return;
  }
  files::RequireExtension(this->Report, { ".html" });
  files::RequireWritable(this->Report);
  if (!vtkMarrowSideBySideScene::HasDisplay())
  {
    throw CommandError(
      "There is no X display to draw the report with: set DISPLAY to one that is there, or put "
      "'xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\"' before the command.");
  }
}

std::vector<vtkPolyData*> CollectionCommand::Label(vtkCollectionTransfer* transfer,
  const std::vector<CollectionEntry>& entries, Console& console) const
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (const CollectionEntry& entry : entries)
  {
    if (entry.Mesh)
    {
      const unsigned int block = blocks->GetNumberOfBlocks();
      blocks->SetBlock(block, entry.Mesh);
      blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), entry.Name.c_str());
    }
  }
  const fs::path pairs = fs::path(this->Output) / ".marrow";
  files::MakeFolder(pairs.string());
  transfer->SetCacheFolder(pairs.c_str());
  transfer->SetNumberOfRejectedAnswers(this->Report.empty() ? 0 : MostRejectedAnswers);
  transfer->SetInputDataObject(blocks);
  {
    const Interrupt interrupt(transfer);
    console.Update(transfer, this->Folder);
    if (interrupt.IsAsked())
    {
      throw CommandError(
        "Stopped. What is done is kept in " + pairs.string() + ": run again to go on.");
    }
  }
  auto* labelled = vtkMultiBlockDataSet::SafeDownCast(transfer->GetOutputDataObject(0));
  std::vector<vtkPolyData*> meshes;
  unsigned int next = 0;
  for (const CollectionEntry& entry : entries)
  {
    auto* mesh = entry.Mesh ? vtkPolyData::SafeDownCast(labelled->GetBlock(next++)) : nullptr;
    // What could not be used goes through as it is.
    meshes.push_back(mesh != entry.Mesh ? mesh : nullptr);
  }
  return meshes;
}

void CollectionCommand::Run(Console& console)
{
  const Processes processes;
  if (!processes.IsFirst())
  {
    // The first one tells what is to be told.
    console.SetQuiet(true);
  }
  else
  {
    this->RequireOutput();
  }
  const std::vector<CollectionEntry> entries = ReadCollection(this->Folder, this->Labels, console);
  vtkNew<vtkCollectionTransfer> transfer;
  transfer->SetController(processes.GetController());
  if (this->IsVoteAlone)
  {
    transfer->LearnFromSourcesOff();
  }
  if (!processes.IsFirst())
  {
    this->Label(transfer, entries, console);
    return;
  }
  for (const CollectionEntry& entry : entries)
  {
    if (!entry.Error.empty())
    {
      Console::ShowError(CommandError(entry.Error));
    }
  }
  const std::vector<vtkPolyData*> meshes = this->Label(transfer, entries, console);
  const std::vector<CollectionRow> rows =
    Summarize(entries, vtkTable::SafeDownCast(transfer->GetOutputDataObject(1)), meshes);
  std::map<std::string, vtkPolyData*> meshOfName;
  std::string failed;
  std::size_t numberOfFailed = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    if (rows[i].Role == "target")
    {
      files::Write(WithoutRejected(meshes[i]),
        (fs::path(this->Output) / (rows[i].Name + "." + this->Format)).string(), console);
    }
    if (meshes[i])
    {
      meshOfName[rows[i].Name] = meshes[i];
    }
    else
    {
      failed += (failed.empty() ? "" : ", ") + rows[i].File;
      ++numberOfFailed;
    }
  }
  files::WriteText((fs::path(this->Output) / "summary.csv").string(), ToCsv(rows));
  files::WriteText((fs::path(this->Output) / "summary.json").string(), ToJson(rows));
  if (!this->Report.empty())
  {
    files::WriteText(this->Report, CollectionReport(rows, meshOfName));
    console.ThrowIfError(this->Report);
  }
  if (numberOfFailed > 0)
  {
    throw CommandError(std::to_string(rows.size() - numberOfFailed) + " of " +
      std::to_string(rows.size()) + " done; " + std::to_string(numberOfFailed) +
      " failed: " + failed);
  }
}
