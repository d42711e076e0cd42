// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TriangleTree_h
#define marrow_TriangleTree_h

#include "TriangleMesh.h"

#include <limits>
#include <vector>

namespace marrow
{
/// The point of a triangle that is nearest to `point`.
Eigen::Vector3d NearestOnTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Triangles of a mesh in a tree of boxes, to search and to sum over. Refers to the mesh, which has
/// to stay.
class TriangleTree
{
public:
  explicit TriangleTree(const TriangleMesh& mesh);
  /// Of some triangles only.
  TriangleTree(const TriangleMesh& mesh, std::vector<int> triangles);

  struct Hit
  {
    int Triangle = -1;
    double SquaredDistance = std::numeric_limits<double>::infinity();
  };
  /// The triangle that is nearest to a point and nearer than `limit`. O(log n) on a surface.
  Hit Nearest(
    const Eigen::Vector3d& point, double limit = std::numeric_limits<double>::infinity()) const;

  /// How often the triangles wind around a point: about 1 inside a closed part, 0 outside, and in
  /// between near the holes of an open one. Far triangles count together, as in the fast winding
  /// number (Barill et al. 2018), right to within a few hundredths. O(log n).
  double WindingNumber(const Eigen::Vector3d& point) const;

  /// Whether the segment from a to b passes through a triangle.
  bool IsCrossedBy(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

private:
  struct Node
  {
    Eigen::Vector3d Low;
    Eigen::Vector3d High;
    Eigen::Vector3d Middle;     ///< area-weighted
    Eigen::Vector3d AreaVector; ///< sum of area times normal
    double Radius;              ///< of a ball about the middle that holds all
    int First;                  ///< of a leaf: its first triangle
    int Count;                  ///< of a leaf; 0: two children, of which one is the next node
    int Second;                 ///< and this the other
  };
  int Build(int first, int count, const std::vector<Eigen::Vector3d>& centroids);
  void Search(int node, const Eigen::Vector3d& point, Hit& best) const;
  double Wind(int node, const Eigen::Vector3d& point) const;
  bool IsCrossed(int node, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  const TriangleMesh& Mesh;
  std::vector<int> Triangles;
  std::vector<Node> Nodes;
};
}

#endif
