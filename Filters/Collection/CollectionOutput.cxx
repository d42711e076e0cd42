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

#include <string>

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

/// A row for each leaf.
template <typename Array, typename ValueOf>
void AddColumn(
  const char* name, const std::vector<CollectionLeaf>& leaves, ValueOf&& valueOf, vtkTable* table)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const CollectionLeaf& leaf : leaves)
  {
    column->InsertNextValue(valueOf(leaf));
  }
  table->AddColumn(column);
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
  table->Initialize();
  AddColumn<vtkStringArray>(
    "Block", leaves, [](const CollectionLeaf& leaf) { return leaf.Name; }, table);
  AddColumn<vtkUnsignedCharArray>(
    "IsSource", leaves, [](const CollectionLeaf& leaf) { return leaf.IsSource ? 1 : 0; }, table);
  AddColumn<vtkStringArray>(
    "Source", leaves,
    [&](const CollectionLeaf& leaf)
    { return leaf.Source >= 0 ? leaves[leaf.Source].Name : std::string(); },
    table);
  AddColumn<vtkDoubleArray>(
    "Confidence", leaves, [](const CollectionLeaf& leaf) { return leaf.MeanConfidence; }, table);
  AddColumn<vtkDoubleArray>(
    "Against", leaves, [](const CollectionLeaf& leaf) { return leaf.Against; }, table);
  AddColumn<vtkDoubleArray>(
    "Learning", leaves, [](const CollectionLeaf& leaf) { return leaf.Learning; }, table);
  AddColumn<vtkDoubleArray>(
    "HeldOutAccuracy", leaves, [](const CollectionLeaf& leaf) { return leaf.HeldOutAccuracy; },
    table);
  AddColumn<vtkDoubleArray>(
    "HeldOutAccuracyLearnt", leaves,
    [](const CollectionLeaf& leaf) { return leaf.HeldOutAccuracyLearnt; }, table);
  AddColumn<vtkStringArray>(
    "Note", leaves, [](const CollectionLeaf& leaf) { return leaf.Note; }, table);
}
}
