// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionOutput_h
#define marrow_CollectionOutput_h

#include "CollectionLeaf.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkAbstractArray;
class vtkPolyData;
class vtkTable;

namespace marrow
{
/// The mesh of a leaf with what was found; `segmentNames`, if there are any, go to those that had no labels.
vtkSmartPointer<vtkPolyData> LabelledMesh(
  const CollectionLeaf& leaf, vtkAbstractArray* segmentNames);

/// The table of vtkCollectionTransfer, a row for each leaf.
void WriteTable(const std::vector<CollectionLeaf>& leaves, vtkTable* table);
}

#endif
