// SPDX-License-Identifier: BSD-3-Clause
// The segments of one mesh on another, the boundaries that carried them, and how sure that is.
//   Transfer [picture.png]
#include <vtkCreatureSource.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSegmentationTransfer.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkCreatureSource> source; // labelled: cell array SegmentId
  source->SetShapeToBiped();
  vtkNew<vtkCreatureSource> target;
  target->SetShapeToBiped();
  target->SetPose(0.7);
  target->SetProportion(0.7);
  target->SetSeed(4);

  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputConnection(0, source->GetOutputPort());
  transfer->SetInputConnection(1, target->GetOutputPort());
  transfer->Update();
  auto* labelled = vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(0));

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(280);
  const int from = scene->AddMesh(source->GetOutput(), nullptr, "source");
  const int to = scene->AddMesh(labelled, nullptr, "target");
  // Ports 1 and 2: the boundaries on source and target, point by point the same.
  scene->AddCurves(
    from, vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(1)), 0.1, 0.1, 0.1);
  scene->AddCurves(to, vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(2)), 0.1, 0.1, 0.1);
  const int sure = scene->AddMesh(labelled, nullptr, "how sure");
  scene->SetSurfaceArray(sure, "SegmentConfidence");
  return scene->WritePNG(argc > 1 ? argv[1] : "transfer.png") ? 0 : 1;
}
