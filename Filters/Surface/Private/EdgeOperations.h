// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_EdgeOperations_h
#define marrow_EdgeOperations_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// An oriented manifold whose edges can be collapsed, one vertex drawn into the other, and flipped. It
/// stays an oriented manifold of the same topology; removed triangles are marked, and their numbers not
/// used again.
class EdgeOperations
{
public:
  explicit EdgeOperations(TriangleMesh mesh);

  const TriangleMesh& Mesh() const { return this->Triangles; }
  bool IsRemoved(int triangle) const { return this->Removed[triangle] != 0; }
  int NumberOfTriangles() const { return this->Left; }
  bool IsBorder(int vertex) const
  {
    return this->Triangles.Opposite[this->Triangles.Outgoing[vertex]] < 0;
  }
  /// The vertex that a vertex was drawn into, directly or not; itself if it is there.
  int Survivor(int vertex);

  /// Whether the edge of a half-edge may collapse, its first vertex (or, if `backward`, its second)
  /// drawn into the other, and leave the topology as it is.
  bool CanCollapse(int halfEdge, bool backward);
  void Collapse(int halfEdge, bool backward);

  /// Whether the edge may be replaced by the other diagonal of its two triangles.
  bool CanFlip(int halfEdge) const;
  void Flip(int halfEdge);

private:
  /// Joins what lies beyond the two other edges of a triangle that vanishes; the apex and the vertex
  /// that stays get a half-edge that does.
  void CloseUp(int halfEdge, int stays);
  void SetOutgoing(int vertex, int halfEdge);

  TriangleMesh Triangles;
  std::vector<char> Removed;
  std::vector<int> Target; ///< per vertex
  std::vector<int> Mark;   ///< per vertex: the last query that saw it
  std::vector<int> Fan;
  int Query = 0;
  int Left = 0;
};
}

#endif
