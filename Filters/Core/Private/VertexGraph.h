// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_VertexGraph_h
#define marrow_VertexGraph_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The edges of a mesh, seen from its vertices, with their lengths: for searches of shortest paths that look at
/// each edge many times.
class VertexGraph
{
public:
  explicit VertexGraph(const TriangleMesh& mesh);

  /// Calls visit(neighbour, length of the edge), in the order of TriangleMesh::ForEachNeighbor.
  template <typename Visit>
  void ForEachEdge(int vertex, Visit&& visit) const
  {
    for (int i = this->Offsets[vertex]; i < this->Offsets[vertex + 1]; ++i)
    {
      visit(this->Ends[i].Vertex, this->Ends[i].Length);
    }
  }

private:
  struct End
  {
    int Vertex;
    double Length;
  };
  std::vector<int> Offsets; ///< per vertex, into Ends
  std::vector<End> Ends;
};
}

#endif
