// SPDX-License-Identifier: BSD-3-Clause
// The program of Filters/README.md.
//   StagesByHand SOURCE.off SOURCE.seg TARGET.off TARGET.seg REFERENCE.seg
#include <vtkMSPSkeleton.h>
#include <vtkMarrowMeshReader.h>
#include <vtkMarrowSegmentReader.h>
#include <vtkMarrowSegmentWriter.h>
#include <vtkMarrowSegmentationMetrics.h>
#include <vtkNew.h>
#include <vtkSegmentationTransfer.h>
#include <vtkSkeletonCorrespondence.h>

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 6)
  {
    return 2;
  }
  vtkNew<vtkMarrowMeshReader> sourceMesh;
  sourceMesh->SetFileName(argv[1]);
  vtkNew<vtkMarrowSegmentReader> source; // the mesh with SegmentId on its cells
  source->SetInputConnection(sourceMesh->GetOutputPort());
  source->SetFileName(argv[2]);
  vtkNew<vtkMarrowMeshReader> target;
  target->SetFileName(argv[3]);

  vtkNew<vtkMSPSkeleton> sourceSkeleton; // runs vtkMSPField itself, as its measures are missing
  sourceSkeleton->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkMSPSkeleton> targetSkeleton;
  targetSkeleton->SetInputConnection(target->GetOutputPort());

  vtkNew<vtkSkeletonCorrespondence> match;
  match->SetInputConnection(0, sourceSkeleton->GetOutputPort(0));
  match->SetInputConnection(1, targetSkeleton->GetOutputPort(0));
  match->SetLeafIndex(0); // 1 is the second best answer, and so on

  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputConnection(0, sourceSkeleton->GetOutputPort(1)); // the mesh with SkeletonNodeId
  transfer->SetInputConnection(1, targetSkeleton->GetOutputPort(1));
  transfer->SetInputConnection(2, match->GetOutputPort(0));
  transfer->SetInputConnection(3, match->GetOutputPort(1));

  vtkNew<vtkMarrowSegmentWriter> writer;
  writer->SetInputConnection(transfer->GetOutputPort());
  writer->SetFileName(argv[4]);
  if (!writer->Write())
  {
    return 1;
  }

  vtkNew<vtkMarrowSegmentReader> reference;
  reference->SetInputConnection(target->GetOutputPort());
  reference->SetFileName(argv[5]);
  vtkNew<vtkMarrowSegmentationMetrics> metrics;
  metrics->SetInputConnection(0, transfer->GetOutputPort());
  metrics->SetInputConnection(1, reference->GetOutputPort());
  metrics->Update();
  std::cout << "label accuracy " << metrics->GetLabelAccuracy() << '\n';
  // On two equal meshes, as the test gives it, hardly any face is wrong.
  return metrics->GetLabelAccuracy() > 0.95 ? 0 : 1;
}
