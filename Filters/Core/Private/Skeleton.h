// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Skeleton_h
#define marrow_Skeleton_h

#include <Eigen/Core>

#include <boost/graph/adjacency_list.hpp>

#include <vector>

namespace marrow
{
/// A point of the skeleton and the part of the mesh that belongs to it.
struct SkeletonNode
{
  Eigen::Vector3d Position = Eigen::Vector3d::Zero();
  std::vector<int> Vertices; ///< φ: the mesh vertices associated with the node, ascending
  double AGD = 0.0;          ///< mean over φ
  double MSP = 0.0;          ///< mean over φ
  double Radius = 0.0;       ///< mean distance from the node to its φ
};

using SkeletonGraph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, SkeletonNode>;

/// The number is the degree, but for junctions of more than three branches.
enum class NodeType
{
  Isolated = 0,
  Terminal = 1,
  Regular = 2,
  Junction = 3
};

/// The path between two feature nodes (terminals, junctions) with only regular nodes inside. A cycle
/// without a feature node is one branch that begins and ends at a promoted regular node.
struct Branch
{
  std::vector<int> Nodes;        ///< in order; the first and the last are feature nodes
  std::vector<double> ArcLength; ///< per node, from the first one, in mesh units

  int Front() const { return this->Nodes.front(); }
  int Back() const { return this->Nodes.back(); }
  double Length() const { return this->ArcLength.back(); }
  bool IsLoop() const { return this->Nodes.size() > 1 && this->Front() == this->Back(); }
};

/// A skeleton: its graph, the branches of that graph, and what later stages need of the mesh.
struct Skeleton
{
  SkeletonGraph Graph;
  std::vector<Branch> Branches;
  double MeshDiagonal = 0.0;   ///< of the mesh's bounding box
  double MeshMaximumMSP = 0.0; ///< the largest MSP of the mesh

  int NumberOfNodes() const { return static_cast<int>(boost::num_vertices(this->Graph)); }
  int NumberOfBranches() const { return static_cast<int>(this->Branches.size()); }
  NodeType TypeOf(int node) const;
  /// Per node: the branches that end at it; a loop is listed twice. Empty for regular nodes.
  std::vector<std::vector<int>> BranchesOfNodes() const;
  /// Number of independent loops: edges - nodes + components.
  int NumberOfLoops() const;
  int NumberOfComponents() const;
  double TotalLength() const;

  /// Fills Branches from Graph, in an order given by the node numbers alone.
  void ExtractBranches();
  /// Brings the branches' arc lengths up to date after nodes were moved.
  void UpdateArcLengths();
};

/// Adds the nodes and branches of another skeleton behind those of the first; φ keeps the numbers that it
/// has. What both keep of their meshes becomes the larger of the two.
void Append(Skeleton& skeleton, const Skeleton& other);
}

#endif
