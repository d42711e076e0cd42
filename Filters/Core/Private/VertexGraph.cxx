// SPDX-License-Identifier: BSD-3-Clause
#include "VertexGraph.h"

namespace marrow
{
VertexGraph::VertexGraph(const TriangleMesh& mesh)
{
  this->Offsets.reserve(mesh.Points.size() + 1);
  this->Ends.reserve(3 * mesh.Triangles.size());
  this->Offsets.push_back(0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    mesh.ForEachNeighbor(v,
      [&](int n) {
        this->Ends.push_back({ n, (mesh.Points[n] - mesh.Points[v]).norm() });
      });
    this->Offsets.push_back(static_cast<int>(this->Ends.size()));
  }
}
}
