// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonBridge_h
#define marrow_SkeletonBridge_h

#include "Skeleton.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace marrow
{
/// A skeleton as vtkPolyData after the data contract: points are nodes, one polyline per branch;
/// point arrays NodeType, Radius, AGD, MSP, VertexCount; cell arrays BranchId, BranchLength; field
/// arrays MeshDiagonal, MeshMaximumMSP.
void ToPolyData(const Skeleton& skeleton, vtkPolyData* output);

/// The way back; φ stays empty. Returns one sentence that says what is wrong, or an empty one.
/// Branches keep the order and direction of the polylines.
std::string ToSkeleton(vtkPolyData* input, Skeleton& skeleton);

/// Per mesh vertex the node whose φ holds it, -1 for none.
std::vector<int> NodeOfVertices(const Skeleton& skeleton, int numberOfVertices);

/// Fills φ from what NodeOfVertices gave. False if a node number is out of range.
bool SetNodeOfVertices(Skeleton& skeleton, const std::vector<int>& nodeOfVertex);
}

#endif
