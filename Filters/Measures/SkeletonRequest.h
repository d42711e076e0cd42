// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonRequest_h
#define marrow_SkeletonRequest_h

#include "Progress.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkInformationVector;

/// For the filters that make a skeleton: not installed, as it speaks Core's private words.
namespace marrow
{
struct MeshReport;
struct Skeleton;
struct TriangleMesh;
struct VertexMeasures;

/// What tells one such filter from another.
struct SkeletonRequest
{
  /// Of the working surface; 0: as many as there are.
  int MaximumFaces = 0;
  /// One sentence on what more than a manifold the filter asks of a body; empty if the body has it.
  std::function<std::string(const MeshReport&)> Check = [](const MeshReport&)
  { return std::string(); };
  /// Where the filter's progress is when the measures are there.
  double ProgressAfterMeasures = 0.5;
  /// Makes the skeleton of a body with φ and the measures of its nodes. One sentence on what is wrong,
  /// or an empty one.
  std::function<std::string(const TriangleMesh&, const VertexMeasures&, const Progress&, Skeleton&)>
    Compute;
};

/// The RequestData of a filter that makes a skeleton: input port 0 the mesh, output port 0 the skeleton,
/// output port 1 the mesh with its measures and SkeletonNodeId. Reports errors; returns what RequestData
/// returns.
int RunSkeletonRequest(vtkAlgorithm* filter, const SkeletonRequest& request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector);
}

#endif
