// SPDX-License-Identifier: BSD-3-Clause
#include "SliceMesh.h"

#include <cstddef>

namespace marrow
{
SliceMesh::SliceMesh(const TriangleMesh& mesh)
  : RankOfVertex(mesh.Points.size(), -1)
{
  // Breadth first over vertices, and triangles in the order in which their first vertex comes.
  const int numberOfTriangles = mesh.NumberOfTriangles();
  std::vector<int> triangleOrder;
  std::vector<int> rankOfTriangle(numberOfTriangles, -1);
  triangleOrder.reserve(numberOfTriangles);
  this->VertexOfRank.reserve(mesh.Points.size());
  const auto enqueue = [this](int vertex)
  {
    if (this->RankOfVertex[vertex] < 0)
    {
      this->RankOfVertex[vertex] = static_cast<int>(this->VertexOfRank.size());
      this->VertexOfRank.push_back(vertex);
    }
  };
  std::size_t front = 0;
  for (int seed = 0; seed < mesh.NumberOfVertices(); ++seed)
  {
    if (mesh.Outgoing[seed] < 0)
    {
      continue;
    }
    enqueue(seed);
    for (; front < this->VertexOfRank.size(); ++front)
    {
      const int vertex = this->VertexOfRank[front];
      mesh.ForEachNeighbor(vertex, enqueue);
      mesh.ForEachOutgoing(vertex,
        [&](int h)
        {
          const int triangle = TriangleMesh::TriangleOf(h);
          if (rankOfTriangle[triangle] < 0)
          {
            rankOfTriangle[triangle] = static_cast<int>(triangleOrder.size());
            triangleOrder.push_back(triangle);
          }
        });
    }
  }

  const auto renumbered = [&](int h)
  { return h < 0 ? -1 : 3 * rankOfTriangle[TriangleMesh::TriangleOf(h)] + h % 3; };
  this->HalfEdges.resize(3 * triangleOrder.size());
  this->Start.resize(this->HalfEdges.size());
  this->Across.resize(this->HalfEdges.size());
  for (int h = 0; h < 3 * numberOfTriangles; ++h)
  {
    const int own = renumbered(h);
    const int next = TriangleMesh::Next(h);
    const int previous = TriangleMesh::Previous(h);
    this->HalfEdges[own] = { this->RankOfVertex[mesh.From(previous)],
      { renumbered(mesh.Opposite[previous]), renumbered(mesh.Opposite[next]) } };
    this->Start[own] = this->RankOfVertex[mesh.From(h)];
    this->Across[own] = renumbered(mesh.Opposite[h]);
  }

  this->Points.reserve(this->VertexOfRank.size());
  this->RingOffset.reserve(this->VertexOfRank.size() + 1);
  this->RingOffset.push_back(0);
  this->Ring.reserve(this->HalfEdges.size());
  for (int vertex : this->VertexOfRank)
  {
    this->Points.push_back(mesh.Points[vertex]);
    mesh.ForEachOutgoing(
      vertex, [&](int h) { this->Ring.push_back(renumbered(TriangleMesh::Next(h))); });
    this->RingOffset.push_back(static_cast<int>(this->Ring.size()));
  }
}
}
