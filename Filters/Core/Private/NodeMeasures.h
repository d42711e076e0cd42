// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_NodeMeasures_h
#define marrow_NodeMeasures_h

#include "Skeleton.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The measures of vtkMSPField that a skeleton is made of, one value per vertex.
struct SkeletonMeasures
{
  std::vector<double> AGD;
  std::vector<double> MSP;
  std::vector<Eigen::Vector3d> MSPCenter;
  std::vector<unsigned char> MSPValid;
};

/// Fills AGD, MSP and Radius of every node from φ (a node without φ takes the mean of its
/// neighbours), and what the skeleton keeps of the mesh: MeshDiagonal, MeshMaximumMSP.
void AverageMeasures(
  Skeleton& skeleton, const TriangleMesh& mesh, const SkeletonMeasures& measures);
}

#endif
