// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCreatureSource.h>
#include <vtkNew.h>
#include <vtkSegmentationTransfer.h>
#include <vtkXMLPolyDataWriter.h>

int main()
{
  vtkNew<vtkCreatureSource> source; // any labelled mesh will do: a cell array SegmentId
  source->SetShapeToQuadruped();
  vtkNew<vtkCreatureSource> target; // any mesh
  target->SetShapeToQuadruped();
  target->SetPose(0.5);
  target->SetProportion(0.5);
  target->SetSeed(7);

  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputConnection(0, source->GetOutputPort());
  transfer->SetInputConnection(1, target->GetOutputPort());

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(transfer->GetOutputPort());
  writer->SetFileName("labelled.vtp");
  return writer->Write() ? 0 : 1;
}
