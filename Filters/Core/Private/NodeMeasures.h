// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_NodeMeasures_h
#define marrow_NodeMeasures_h

#include "Skeleton.h"
#include "TriangleMesh.h"
#include "VertexMeasures.h"

namespace marrow
{
/// Fills AGD, MSP and Radius of every node from φ (a node without φ takes the mean of its
/// neighbours), and what the skeleton keeps of the mesh: MeshDiagonal, MeshMaximumMSP.
void AverageMeasures(Skeleton& skeleton, const TriangleMesh& mesh, const VertexMeasures& measures);
}

#endif
