// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonCommand.h"

#include "Console.h"
#include "MeshFiles.h"

#include <vtkMSPSkeleton.h>
#include <vtkPolyData.h>

CLI::App* SkeletonCommand::Declare(CLI::App& marrow)
{
  CLI::App* app = marrow.add_subcommand("skeleton", "Compute the skeleton of a mesh");
  // Not "mesh": later versions of CLI11 than 2.3 take that for the option --mesh.
  app->add_option("input", this->Mesh, "Mesh (" + files::ReadableMeshes() + ")")->required();
  app->add_option("-o,--output", this->Output, "The skeleton (.vtp .vtk)")->required();
  app->add_option(
    "--mesh", this->MeshOutput, "Also write the mesh with its measures and SkeletonNodeId");
  app->footer("Example:\n  marrow skeleton camel.off -o camel_skeleton.vtp --mesh camel.vtp");
  return app;
}

void SkeletonCommand::Run(Console& console)
{
  files::RequireExtension(this->Output, { ".vtp", ".vtk" });
  files::RequireWritable(this->Output);
  if (!this->MeshOutput.empty())
  {
    files::RequireExtension(this->MeshOutput, { ".vtp", ".vtk" });
    files::RequireWritable(this->MeshOutput);
  }
  vtkNew<vtkMSPSkeleton> skeleton;
  skeleton->SetInputData(files::ReadMesh(this->Mesh, console));
  console.Update(skeleton, this->Mesh);
  files::ShowNote(skeleton->GetOutputDataObject(1), this->Mesh, console);
  files::Write(vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(0)), this->Output, console);
  if (!this->MeshOutput.empty())
  {
    files::Write(
      vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(1)), this->MeshOutput, console);
  }
}
