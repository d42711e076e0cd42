// SPDX-License-Identifier: BSD-3-Clause
#include "CorrespondCommand.h"

#include "Console.h"
#include "MeshFiles.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMSPSkeleton.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSkeletonCorrespondence.h>

#include <map>
#include <sstream>

namespace
{
/// Per correspondence id the indices that have it, separated by spaces: groups match groups.
std::map<vtkIdType, std::string> IndicesOfIds(vtkDataArray* ids)
{
  std::map<vtkIdType, std::string> indices;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
    if (id >= 0)
    {
      std::string& list = indices[id];
      list += (list.empty() ? "" : " ") + std::to_string(i);
    }
  }
  return indices;
}

void WritePairs(
  std::ostream& table, const std::string& kind, vtkDataArray* source, vtkDataArray* target)
{
  std::map<vtkIdType, std::string> targets = IndicesOfIds(target);
  for (const auto& [id, indices] : IndicesOfIds(source))
  {
    table << kind << "," << id << "," << indices << "," << targets[id] << "\n";
  }
}
}

CLI::App* CorrespondCommand::Declare(CLI::App& marrow)
{
  CLI::App* app = marrow.add_subcommand(
    "correspond", "Match the skeletons of two meshes; write the matched nodes and branches");
  app->add_option("source", this->Source, "Source mesh")->required();
  app->add_option("target", this->Target, "Target mesh")->required();
  app->add_option("-o,--output", this->Output, "Table of the matched nodes and branches (.csv)")
    ->required();
  app->add_option("--matcher", this->Matcher, "Correspondence tree or electors voting")
    ->check(CLI::IsMember({ "tree", "electors" }))
    ->capture_default_str();
  this->Hints.Declare(*app);
  app
    ->add_option("--skeletons", this->Skeletons,
      "Where to write the two matched skeletons (.vtp), to be drawn by marrow render")
    ->expected(2);
  app->footer(
    "The table has one row per match: node or branch, its id, and the indices of the skeletons' "
    "points or polylines in source and target, several where parts were merged.\n"
    "Example:\n  marrow correspond camel.off cow.off -o pairs.csv\n"
    "  marrow correspond camel.off cow.off -o pairs.csv --skeletons camel.vtp cow.vtp\n"
    "  marrow render camel.off cow.off --skeletons camel.vtp cow.vtp --matches -o matched.png");
  return app;
}

void CorrespondCommand::Run(Console& console)
{
  files::RequireExtension(this->Output, { ".csv" });
  files::RequireWritable(this->Output);
  for (const std::string& skeleton : this->Skeletons)
  {
    files::RequireExtension(skeleton, { ".vtp" });
    files::RequireWritable(skeleton);
  }
  const vtkSmartPointer<vtkPolyData> sourceMesh = files::ReadMesh(this->Source, console);
  vtkNew<vtkMSPSkeleton> source;
  source->SetInputData(sourceMesh);
  console.Update(source, this->Source);
  files::ShowNote(source->GetOutputDataObject(1), this->Source, console);
  vtkNew<vtkMSPSkeleton> target;
  const vtkSmartPointer<vtkPolyData> targetMesh = files::ReadMesh(this->Target, console);
  target->SetInputData(targetMesh);
  console.Update(target, this->Target);
  files::ShowNote(target->GetOutputDataObject(1), this->Target, console);

  vtkNew<vtkSkeletonCorrespondence> correspondence;
  correspondence->SetMatcher(this->Matcher == "electors"
      ? vtkSkeletonCorrespondence::ELECTORS_VOTING
      : vtkSkeletonCorrespondence::CORRESPONDENCE_TREE);
  correspondence->SetInputConnection(0, source->GetOutputPort(0));
  correspondence->SetInputConnection(1, target->GetOutputPort(0));
  if (!this->Hints.IsEmpty())
  {
    this->Hints.Connect(
      correspondence, { 2, sourceMesh, this->Source }, { 3, targetMesh, this->Target });
  }
  console.Update(correspondence, this->Source + " and " + this->Target);

  auto* matchedSource = vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(0));
  auto* matchedTarget = vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(1));
  std::ostringstream table;
  table << "Kind,CorrespondenceId,Source,Target\n";
  WritePairs(table, "node", matchedSource->GetPointData()->GetArray("CorrespondenceId"),
    matchedTarget->GetPointData()->GetArray("CorrespondenceId"));
  WritePairs(table, "branch", matchedSource->GetCellData()->GetArray("BranchCorrespondenceId"),
    matchedTarget->GetCellData()->GetArray("BranchCorrespondenceId"));
  files::WriteText(this->Output, table.str());
  if (!this->Skeletons.empty())
  {
    files::Write(matchedSource, this->Skeletons[0], console);
    files::Write(matchedTarget, this->Skeletons[1], console);
  }
}
