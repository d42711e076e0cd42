// SPDX-License-Identifier: BSD-3-Clause
// Which parts of two meshes are the same, by their skeletons.
//   Correspondence [picture.png]
#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkFieldData.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSkeletonCorrespondence.h>

#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkCreatureSource> meshes[2];
  vtkNew<vtkMSPSkeleton> skeletons[2];
  vtkNew<vtkSkeletonCorrespondence> correspondence;
  for (int i = 0; i < 2; ++i)
  {
    meshes[i]->SetShapeToQuadruped();
    meshes[i]->SetPose(0.5 * i);
    meshes[i]->SetProportion(0.5 * i);
    meshes[i]->SetSeed(1 + i);
    skeletons[i]->SetInputConnection(meshes[i]->GetOutputPort());
    correspondence->SetInputConnection(i, skeletons[i]->GetOutputPort());
  }
  correspondence->Update();

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileHeight(320);
  scene->SetSurfaceOpacity(0.15);
  scene->SetLabelArrayName(""); // the surfaces plain
  scene->SetColorSkeletonBy(vtkMarrowSkeletonGlyphs::CORRESPONDENCE);
  scene->ShowLinksOn();
  for (int i = 0; i < 2; ++i)
  {
    // Equal CorrespondenceId: the same node; equal BranchCorrespondenceId: the same branch.
    auto* matched = vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(i));
    scene->AddMesh(meshes[i]->GetOutput(), matched, i == 0 ? "source" : "target");
    std::cout << "confidence "
              << matched->GetFieldData()->GetArray("CorrespondenceConfidence")->GetTuple1(0)
              << "\n";
  }
  return scene->WritePNG(argc > 1 ? argv[1] : "correspondence.png") ? 0 : 1;
}
