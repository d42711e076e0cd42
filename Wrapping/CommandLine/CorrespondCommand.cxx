// SPDX-License-Identifier: BSD-3-Clause
#include "CorrespondCommand.h"

#include "Console.h"
#include "MeshFiles.h"

#include <vtkMSPSkeleton.h>
#include <vtkPolyData.h>
#include <vtkSkeletonCorrespondence.h>
#include <vtkTable.h>

CLI::App* CorrespondCommand::Declare(CLI::App& marrow)
{
  CLI::App* app = marrow.add_subcommand(
    "correspond", "Match the skeletons of two meshes; write the matched nodes and branches");
  app->add_option("source", this->Source, "Source mesh")->required();
  app->add_option("target", this->Target, "Target mesh")->required();
  app->add_option("-o,--output", this->Output, "Table of the matched pairs (.csv)")->required();
  app->footer("Example:\n  marrow correspond camel.off cow.off -o pairs.csv");
  return app;
}

void CorrespondCommand::Run(Console& console)
{
  files::RequireExtension(this->Output, { ".csv" });
  vtkNew<vtkMSPSkeleton> source;
  source->SetInputData(files::ReadMesh(this->Source, console));
  console.Update(source, this->Source);
  vtkNew<vtkMSPSkeleton> target;
  target->SetInputData(files::ReadMesh(this->Target, console));
  console.Update(target, this->Target);

  vtkNew<vtkSkeletonCorrespondence> correspondence;
  correspondence->SetInputConnection(0, source->GetOutputPort(0));
  correspondence->SetInputConnection(1, target->GetOutputPort(0));
  console.Update(correspondence, this->Source + " and " + this->Target);
  files::WriteTable(
    vtkTable::SafeDownCast(correspondence->GetOutputDataObject(2)), this->Output, console);
}
