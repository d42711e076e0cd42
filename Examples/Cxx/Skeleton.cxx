// SPDX-License-Identifier: BSD-3-Clause
// The skeleton of a mesh, and the part of the surface that belongs to each branch.
//   Skeleton [picture.png]
#include <vtkCreatureSource.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkCreatureSource> mesh;
  mesh->SetShapeToBiped();
  mesh->SetPose(0.6);

  vtkNew<vtkMSPSkeleton> filter;
  filter->SetInputConnection(mesh->GetOutputPort());
  filter->Update();
  auto* skeleton = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  // The mesh again, with the point array SkeletonNodeId: the node that each vertex belongs to.
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  std::cout << skeleton->GetNumberOfPoints() << " nodes in " << skeleton->GetNumberOfLines()
            << " branches; vertex 0 belongs to node "
            << surface->GetPointData()->GetArray("SkeletonNodeId")->GetTuple1(0) << "\n";

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(300);
  scene->AddMesh(surface, nullptr, "surface");
  const int tile = scene->AddMesh(surface, skeleton, "skeleton");
  scene->SetTileOpacity(tile, 0.25);
  return scene->WritePNG(argc > 1 ? argv[1] : "skeleton.png") ? 0 : 1;
}
