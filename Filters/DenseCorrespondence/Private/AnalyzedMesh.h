// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnalyzedMesh_h
#define marrow_AnalyzedMesh_h

#include "Skeleton.h"
#include "SliceChain.h"
#include "TriangleMesh.h"

#include <memory>
#include <vector>

namespace marrow
{
/// A mesh and all that the earlier stages found out about it.
struct AnalyzedMesh
{
  TriangleMesh Mesh;
  marrow::Skeleton Skeleton;                ///< φ is filled
  std::vector<int> NodeOfVertex;            ///< no vertex is without a node: see FillNodeOfVertex
  std::vector<double> AGD;                  ///< per vertex, [0,1] over the mesh
  std::vector<double> MSP;                  ///< per vertex, mesh units
  std::vector<double> GradientMagnitude;    ///< per vertex |∇MSP|
  std::vector<double> DihedralAngle;        ///< per vertex, radians
  std::shared_ptr<const SliceChain> Slices; ///< of a surface of revolution; null for others

  double Diagonal() const { return this->Skeleton.MeshDiagonal; }
};

/// Gives every vertex without a node (-1: it belonged to a pruned spur) the node of the vertex
/// nearest to it along the mesh, as far as there is any in its component.
void FillNodeOfVertex(const TriangleMesh& mesh, std::vector<int>& nodeOfVertex);
}

#endif
