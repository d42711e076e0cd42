// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PreparedMesh_h
#define marrow_PreparedMesh_h

#include "Method.h"
#include "Skeleton.h"
#include "TriangleMesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

namespace marrow::bench
{
/// A mesh of the benchmark with all that its pairs need, computed once.
struct PreparedMesh
{
  int Id = 0;
  /// All arrays of the filters; SegmentId holds the pieces.
  vtkSmartPointer<vtkPolyData> Surface = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkPolyData> Skeleton = vtkSmartPointer<vtkPolyData>::New();

  TriangleMesh Mesh;
  std::vector<double> Areas;
  std::vector<int> Labels;
  std::vector<int> Pieces;
  std::map<int, int> LabelOfPiece;
  std::vector<std::vector<int>> Humans;
  std::vector<int> Features;
  marrow::Skeleton PlainSkeleton; ///< with φ
  std::vector<int> NodeOfVertex;

  double SecondsForField = 0.0;
  double SecondsForSkeleton = 0.0;
  std::string Error; ///< why there is no skeleton; empty if all went well
};

/// Whether the program was built with vtkMarrowMeanCurvatureSkeleton.
bool HasMeanCurvatureSkeleton();

/// Runs vtkMSPField and the skeleton's filter with their defaults on the mesh; fills Surface,
/// Skeleton, the times and Error.
PreparedMesh ComputeSkeleton(const std::string& folder, int mesh, SkeletonKind kind);

/// Fills the rest from Surface, Skeleton and the benchmark's files; adds to Error.
void ReadGroundTruth(const std::string& folder, PreparedMesh& mesh);

/// The id of most corners of faces at the φ of `nodes`, -1 where that is empty; `ids` are per face.
int MajorityOfNodes(
  const PreparedMesh& mesh, const std::vector<int>& nodes, const std::vector<int>& ids);
}

#endif
