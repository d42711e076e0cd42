// SPDX-License-Identifier: BSD-3-Clause
// What vtkMSPField finds out about a surface: how far from the middle (AGD), how thick (MSP), and
// where the thickness changes (MSPGradient).
//   Measures [picture.png]
#include <vtkCreatureSource.h>
#include <vtkMSPField.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkCreatureSource> mesh; // or a reader: any triangle mesh
  mesh->SetShapeToQuadruped();

  vtkNew<vtkMSPField> measures;
  measures->SetInputConnection(mesh->GetOutputPort());
  measures->Update();

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(280);
  scene->SetTileHeight(260);
  for (const char* name : { "AGD", "MSP", "MSPGradient" })
  {
    const int tile = scene->AddMesh(measures->GetOutput());
    scene->SetSurfaceArray(tile, name);
  }
  return scene->WritePNG(argc > 1 ? argv[1] : "measures.png") ? 0 : 1;
}
