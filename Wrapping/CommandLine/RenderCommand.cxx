// SPDX-License-Identifier: BSD-3-Clause
#include "RenderCommand.h"

#include "CommandError.h"
#include "Console.h"
#include "MeshFiles.h"

#include <vtkMarrowSideBySideScene.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkPolyData.h>

CLI::App* RenderCommand::Declare(CLI::App& marrow)
{
  CLI::App* app =
    marrow.add_subcommand("render", "Draw meshes side by side; equal segments have equal colours");
  app->add_option("meshes", this->Meshes, "Meshes; their cell array SegmentId gives the colours")
    ->required();
  app->add_option("-o,--output", this->Output, "Picture (.png)")->required();
  app->add_option("--skeletons", this->Skeletons,
    "Skeletons of the meshes, in the same order, to be drawn inside of transparent surfaces");
  app->add_flag("--matches", this->ShowMatches,
    "Matched parts of the skeletons in equal colours, with lines between matched nodes");
  app->add_option("--color-by", this->Measures,
    "Arrays to colour by in place of the segments, such as AGD MSP MSPGradient; one picture of "
    "each "
    "mesh for every one of them");
  app->add_option("--segments", this->Segments,
    "Segments of the first mesh: a .seg file, or a mesh of the same faces with SegmentId");
  app->add_option("--captions", this->Captions, "One per mesh (default: the file names)");
  app->add_option("--up", this->ViewUp, "Direction that is up in the first mesh")
    ->expected(3)
    ->capture_default_str();
  app
    ->add_option("--from", this->ViewDirection,
      "Direction from the first mesh to the eye (default: its broad side)")
    ->expected(3);
  app->add_option("--azimuth", this->Azimuth, "Turn of the eye to the side, degrees")
    ->check(CLI::Range(-180.0, 180.0))
    ->capture_default_str();
  app->add_option("--elevation", this->Elevation, "Turn of the eye upwards, degrees")
    ->check(CLI::Range(-89.0, 89.0))
    ->capture_default_str();
  app->add_option("--opacity", this->Opacity, "Of the surfaces (default: 1, with skeletons 0.3)")
    ->check(CLI::Range(0.0, 1.0));
  app->add_option("--columns", this->Columns, "Meshes in a row (default: all)")
    ->check(CLI::Range(1, 64));
  app->add_option("--tile", this->TileSize, "Width and height per mesh, pixels")
    ->expected(2)
    ->check(CLI::Range(16, 4096))
    ->capture_default_str();
  app->add_flag("--no-align", this->DoNotAlign,
    "Show the meshes as they are in their files, not turned to stand like the first one");
  app->footer("Examples:\n"
              "  marrow render camel.vtp cow.vtp bull.vtp -o animals.png\n"
              "  marrow render camel.vtp cow.vtp --skeletons camel_skeleton.vtp cow_skeleton.vtp "
              "-o skeletons.png\n"
              "  marrow measure camel.off -o camel.vtp\n"
              "  marrow render camel.vtp --color-by AGD MSP MSPGradient -o measures.png\n"
              "Drawing needs an X display; without one: xvfb-run marrow render ...");
  return app;
}

void RenderCommand::Run(Console& console)
{
  files::RequireExtension(this->Output, { ".png" });
  files::RequireWritable(this->Output);
  if (!this->Skeletons.empty() && this->Skeletons.size() != this->Meshes.size())
  {
    throw CommandError("--skeletons: there are " + std::to_string(this->Skeletons.size()) +
      " for " + std::to_string(this->Meshes.size()) + " meshes; name one per mesh.");
  }
  if (this->ShowMatches && this->Skeletons.empty())
  {
    throw CommandError(
      "--matches: there are no skeletons; name those of marrow correspond by --skeletons.");
  }
  if (!this->Captions.empty() && this->Captions.size() != this->Meshes.size())
  {
    throw CommandError("--captions: there are " + std::to_string(this->Captions.size()) + " for " +
      std::to_string(this->Meshes.size()) + " meshes; write one per mesh.");
  }
  if (!vtkMarrowSideBySideScene::HasDisplay())
  {
    // VTK would end the program itself, with a stack of messages.
    throw CommandError(
      "There is no X display to draw with: set DISPLAY to one that is there, or put "
      "'xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\"' before the command.");
  }

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetViewUp(this->ViewUp.data());
  scene->SetViewDirection(this->ViewDirection.data());
  scene->SetAzimuth(this->Azimuth);
  scene->SetElevation(this->Elevation);
  scene->SetAlign(!this->DoNotAlign);
  scene->SetColumns(this->Columns);
  scene->SetTileWidth(this->TileSize[0]);
  scene->SetTileHeight(this->TileSize[1]);
  if (this->ShowMatches)
  {
    scene->SetColorSkeletonBy(vtkMarrowSkeletonGlyphs::CORRESPONDENCE);
    scene->ShowLinksOn();
  }
  const double opacity = this->Skeletons.empty() ? 1.0 : 0.3;
  scene->SetSurfaceOpacity(this->Opacity >= 0.0 ? this->Opacity : opacity);
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    const bool hasSegments = i == 0 && !this->Segments.empty();
    const vtkSmartPointer<vtkPolyData> mesh = hasSegments
      ? files::ReadSegmented(this->Meshes[i], { this->Segments }, console)
      : files::ReadMesh(this->Meshes[i], console);
    vtkSmartPointer<vtkPolyData> skeleton;
    if (!this->Skeletons.empty())
    {
      skeleton = files::ReadPolyData(this->Skeletons[i], console);
    }
    const std::string caption =
      this->Captions.empty() ? files::Stem(this->Meshes[i]) : this->Captions[i];
    if (this->Measures.empty())
    {
      scene->AddMesh(mesh, skeleton, caption.c_str());
    }
    for (const std::string& measure : this->Measures)
    {
      scene->SetSurfaceArray(scene->AddMesh(mesh, skeleton, caption.c_str()), measure.c_str());
      console.ThrowIfError(this->Meshes[i]);
    }
  }
  scene->WritePNG(this->Output.c_str());
  console.ThrowIfError(this->Output);
}
