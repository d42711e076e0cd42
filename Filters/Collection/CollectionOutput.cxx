// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionOutput.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MeshBridge.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

namespace marrow
{
namespace
{
/// The answers that were not taken, a component of the arrays for each.
void WriteRejected(const std::vector<RejectedAnswer>& rejected, vtkPolyData* output)
{
  const int size = static_cast<int>(rejected.size());
  vtkNew<vtkIntArray> labels;
  labels->SetName(names::RejectedSegmentId);
  labels->SetNumberOfComponents(size);
  labels->SetNumberOfTuples(output->GetNumberOfCells());
  vtkNew<vtkDoubleArray> against;
  against->SetName(names::RejectedAgainst);
  vtkNew<vtkDoubleArray> difference;
  difference->SetName(names::RejectedDifference);
  for (int i = 0; i < size; ++i)
  {
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      labels->SetTypedComponent(cell, i, rejected[i].Labels[cell]);
    }
    against->InsertNextValue(rejected[i].Against);
    difference->InsertNextValue(rejected[i].Difference);
  }
  output->GetCellData()->AddArray(labels);
  output->GetFieldData()->AddArray(against);
  output->GetFieldData()->AddArray(difference);
}

}

vtkSmartPointer<vtkPolyData> LabelledMesh(
  const CollectionLeaf& leaf, vtkAbstractArray* segmentNames)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(leaf.Mesh);
  SetIntArray(output->GetCellData(), names::SegmentId, leaf.Labels);
  output->GetCellData()->SetActiveScalars(names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  SetArray(output->GetCellData(), names::SegmentConfidence, leaf.Confidence);
  if (segmentNames && !leaf.IsSource)
  {
    output->GetFieldData()->RemoveArray(names::SegmentName);
    output->GetFieldData()->AddArray(segmentNames);
  }
  if (!leaf.Rejected.empty())
  {
    WriteRejected(leaf.Rejected, output);
  }
  WriteNote(leaf.Collected->Side.Surface, output);
  return output;
}

void WriteTable(const std::vector<CollectionLeaf>& leaves, vtkTable* table)
{
  vtkNew<vtkStringArray> block;
  block->SetName("Block");
  vtkNew<vtkUnsignedCharArray> isSource;
  isSource->SetName("IsSource");
  vtkNew<vtkStringArray> source;
  source->SetName("Source");
  vtkNew<vtkDoubleArray> confidence;
  confidence->SetName("Confidence");
  vtkNew<vtkDoubleArray> against;
  against->SetName("Against");
  vtkNew<vtkDoubleArray> learning;
  learning->SetName("Learning");
  vtkNew<vtkDoubleArray> heldOut;
  heldOut->SetName("HeldOutAccuracy");
  vtkNew<vtkDoubleArray> heldOutLearnt;
  heldOutLearnt->SetName("HeldOutAccuracyLearnt");
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  for (const CollectionLeaf& leaf : leaves)
  {
    block->InsertNextValue(leaf.Name);
    isSource->InsertNextValue(leaf.IsSource ? 1 : 0);
    source->InsertNextValue(leaf.Source >= 0 ? leaves[leaf.Source].Name : "");
    confidence->InsertNextValue(leaf.MeanConfidence);
    against->InsertNextValue(leaf.Against);
    learning->InsertNextValue(leaf.Learning);
    heldOut->InsertNextValue(leaf.HeldOutAccuracy);
    heldOutLearnt->InsertNextValue(leaf.HeldOutAccuracyLearnt);
    note->InsertNextValue(leaf.Note);
  }
  table->Initialize();
  for (vtkAbstractArray* column :
    { static_cast<vtkAbstractArray*>(block.Get()), static_cast<vtkAbstractArray*>(isSource.Get()),
      static_cast<vtkAbstractArray*>(source.Get()),
      static_cast<vtkAbstractArray*>(confidence.Get()),
      static_cast<vtkAbstractArray*>(against.Get()), static_cast<vtkAbstractArray*>(learning.Get()),
      static_cast<vtkAbstractArray*>(heldOut.Get()),
      static_cast<vtkAbstractArray*>(heldOutLearnt.Get()),
      static_cast<vtkAbstractArray*>(note.Get()) })
  {
    table->AddColumn(column);
  }
}
}
