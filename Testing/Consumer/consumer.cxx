// SPDX-License-Identifier: BSD-3-Clause
// Built against the installed package: a transfer between two creatures, its labels compared with
// those that the target was made with, and one object of every other module.
#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkDataArray.h>
#include <vtkMSPField.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowLabelColors.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSegmentationTransfer.h>
#include <vtkSkeletonCorrespondence.h>

#include <iostream>

int main()
{
  vtkNew<vtkMSPField> measures;
  vtkNew<vtkMSPSkeleton> skeleton;
  vtkNew<vtkSkeletonCorrespondence> correspondence;
  double rgb[3];
  vtkMarrowLabelColors::GetColor(1, rgb);

  vtkNew<vtkCreatureSource> source;
  source->SetResolution(3000);
  vtkNew<vtkCreatureSource> target;
  target->SetResolution(4000);
  target->SetPose(0.3);
  target->SetSeed(2);
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputConnection(0, source->GetOutputPort());
  transfer->SetInputConnection(1, target->GetOutputPort());
  transfer->Update();

  auto* labelled = vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(0));
  vtkDataArray* truth = target->GetOutput()->GetCellData()->GetArray("SegmentId");
  vtkDataArray* labels = labelled ? labelled->GetCellData()->GetArray("SegmentId") : nullptr;
  if (!labels || labels->GetNumberOfTuples() != truth->GetNumberOfTuples())
  {
    std::cerr << "The transfer gave no labels." << std::endl;
    return 1;
  }
  vtkIdType equal = 0;
  for (vtkIdType i = 0; i < truth->GetNumberOfTuples(); ++i)
  {
    equal += labels->GetTuple1(i) == truth->GetTuple1(i) ? 1 : 0;
  }
  const double accuracy = static_cast<double>(equal) / truth->GetNumberOfTuples();
  std::cout << "Faces with the right label: " << 100.0 * accuracy << " %" << std::endl;
  return accuracy > 0.8 ? 0 : 1;
}
