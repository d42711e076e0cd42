// SPDX-License-Identifier: BSD-3-Clause
// A whole collection from one labelled mesh. The source is analyzed once: its skeleton is an input
// of every transfer.
//   Collection [picture.png]
#include <vtkCreatureSource.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSegmentationTransfer.h>

#include <string>

int main(int argc, char* argv[])
{
  vtkNew<vtkCreatureSource> source;
  source->SetShapeToQuadruped();
  vtkNew<vtkMSPSkeleton> sourceSkeleton;
  sourceSkeleton->SetInputConnection(source->GetOutputPort());

  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputConnection(0, sourceSkeleton->GetOutputPort(1)); // the mesh with its measures
  transfer->SetInputConnection(2, sourceSkeleton->GetOutputPort(0)); // the skeleton

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(270);
  scene->SetTileHeight(230);
  scene->SetColumns(3);
  source->Update();
  scene->AddMesh(source->GetOutput(), nullptr, "source");

  for (int seed = 2; seed <= 6; ++seed)
  {
    vtkNew<vtkCreatureSource> target;
    target->SetShapeToQuadruped();
    target->SetSeed(seed);
    target->SetPose(0.8);
    target->SetProportion(0.8);
    transfer->SetInputConnection(1, target->GetOutputPort());
    transfer->Update();
    vtkNew<vtkPolyData> labelled; // the filter's own output is overwritten by the next transfer
    labelled->DeepCopy(transfer->GetOutputDataObject(0));
    scene->AddMesh(labelled, nullptr, ("target " + std::to_string(seed)).c_str());
  }
  return scene->WritePNG(argc > 1 ? argv[1] : "collection.png") ? 0 : 1;
}
