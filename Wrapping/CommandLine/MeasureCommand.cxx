// SPDX-License-Identifier: BSD-3-Clause
#include "MeasureCommand.h"

#include "Console.h"
#include "MeshFiles.h"

#include <vtkMSPField.h>
#include <vtkPolyData.h>

CLI::App* MeasureCommand::Declare(CLI::App& marrow)
{
  CLI::App* app = marrow.add_subcommand(
    "measure", "Measure a mesh: AGD, MSP with its slices, MSP gradient, dihedral angle");
  app->add_option("mesh", this->Mesh, "Mesh to measure (" + files::ReadableMeshes() + ")")
    ->required();
  app->add_option("-o,--output", this->Output, "The mesh with the measures (.vtp .vtk)")
    ->required();
  app
    ->add_option("--maximum-faces", this->MaximumFaces,
      "Measure a mesh of more faces on a working surface of so many, in a fraction of the time; "
      "0: at every vertex")
    ->capture_default_str();
  app->footer("Example:\n  marrow measure camel.off -o camel.vtp");
  return app;
}

void MeasureCommand::Run(Console& console)
{
  files::RequireExtension(this->Output, { ".vtp", ".vtk" });
  files::RequireWritable(this->Output);
  vtkNew<vtkMSPField> measure;
  measure->SetInputData(files::ReadMesh(this->Mesh, console));
  measure->SetMaximumFaces(this->MaximumFaces);
  console.Update(measure, this->Mesh);
  files::ShowNote(measure->GetOutput(), this->Mesh, console);
  files::Write(measure->GetOutput(), this->Output, console);
}
