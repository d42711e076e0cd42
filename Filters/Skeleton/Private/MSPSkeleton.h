// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MSPSkeleton_h
#define marrow_MSPSkeleton_h

#include "Progress.h"
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

/// The MSP skeleton of a manifold mesh (correspondence paper, section 5): shrink, collapse, prune,
/// even out, centre. Several components give several skeletons in one. Returns a skeleton without
/// nodes when `progress` asks to stop.
/// `finestArea` is the least share of the mesh's area of a limb (see PruneSpurs); `spacing` the
/// distance of the nodes along a branch, in mesh units.
Skeleton ComputeMSPSkeleton(const TriangleMesh& mesh, const SkeletonMeasures& measures,
  double finestArea, double spacing, const Progress& progress);

/// Fills AGD, MSP and Radius of every node from φ; a node without φ takes the mean of its neighbours.
void AverageMeasures(
  Skeleton& skeleton, const TriangleMesh& mesh, const SkeletonMeasures& measures);
}

#endif
