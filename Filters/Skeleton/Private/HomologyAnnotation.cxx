// SPDX-License-Identifier: BSD-3-Clause
#include "HomologyAnnotation.h"

namespace marrow
{
namespace
{
/// Marks the half-edges of a spanning forest of the vertices, both of each edge.
std::vector<char> SpanVertices(const TriangleMesh& mesh)
{
  std::vector<char> inTree(mesh.Opposite.size(), 0);
  std::vector<char> reached(mesh.Points.size(), 0);
  std::vector<int> queue;
  for (int root = 0; root < mesh.NumberOfVertices(); ++root)
  {
    if (reached[root] || mesh.Outgoing[root] < 0)
    {
      continue;
    }
    reached[root] = 1;
    queue.assign(1, root);
    for (std::size_t head = 0; head < queue.size(); ++head)
    {
      mesh.ForEachOutgoing(queue[head],
        [&](int h)
        {
          const int neighbor = mesh.To(h);
          if (!reached[neighbor])
          {
            reached[neighbor] = 1;
            inTree[h] = inTree[mesh.Opposite[h]] = 1;
            queue.push_back(neighbor);
          }
        });
    }
  }
  return inTree;
}

struct DualTree
{
  std::vector<int> ParentHalfEdge; ///< of the triangle itself, -1 at a root
  std::vector<int> Depth;
  std::vector<char> Crossed; ///< per half-edge: a dual tree edge crosses it
};

DualTree SpanTriangles(const TriangleMesh& mesh, const std::vector<char>& inPrimalTree)
{
  DualTree tree;
  tree.ParentHalfEdge.assign(mesh.Triangles.size(), -1);
  tree.Depth.assign(mesh.Triangles.size(), -1);
  tree.Crossed.assign(mesh.Opposite.size(), 0);
  std::vector<int> queue;
  for (int root = 0; root < mesh.NumberOfTriangles(); ++root)
  {
    if (tree.Depth[root] >= 0)
    {
      continue;
    }
    tree.Depth[root] = 0;
    queue.assign(1, root);
    for (std::size_t head = 0; head < queue.size(); ++head)
    {
      for (int h = 3 * queue[head]; h < 3 * queue[head] + 3; ++h)
      {
        const int opposite = mesh.Opposite[h];
        const int neighbor = TriangleMesh::TriangleOf(opposite);
        if (!inPrimalTree[h] && tree.Depth[neighbor] < 0)
        {
          tree.Depth[neighbor] = tree.Depth[queue[head]] + 1;
          tree.ParentHalfEdge[neighbor] = opposite;
          tree.Crossed[h] = tree.Crossed[opposite] = 1;
          queue.push_back(neighbor);
        }
      }
    }
  }
  return tree;
}
}

std::vector<HomologyClass> AnnotateHalfEdges(const TriangleMesh& closedMesh)
{
  const std::vector<char> inTree = SpanVertices(closedMesh);
  const DualTree dual = SpanTriangles(closedMesh, inTree);

  std::vector<int> generators;
  for (int h = 0; h < static_cast<int>(closedMesh.Opposite.size()); ++h)
  {
    if (h < closedMesh.Opposite[h] && !inTree[h] && !dual.Crossed[h])
    {
      generators.push_back(h);
    }
  }

  std::vector<HomologyClass> annotation(
    closedMesh.Opposite.size(), HomologyClass((generators.size() + 63) / 64, 0));
  for (std::size_t bit = 0; bit < generators.size(); ++bit)
  {
    const auto flip = [&](int h)
    {
      annotation[h][bit / 64] ^= std::uint64_t(1) << (bit % 64);
      annotation[closedMesh.Opposite[h]][bit / 64] ^= std::uint64_t(1) << (bit % 64);
    };
    flip(generators[bit]);
    int a = TriangleMesh::TriangleOf(generators[bit]);
    int b = TriangleMesh::TriangleOf(closedMesh.Opposite[generators[bit]]);
    while (a != b)
    {
      int& deeper = dual.Depth[a] >= dual.Depth[b] ? a : b;
      const int h = dual.ParentHalfEdge[deeper];
      flip(h);
      deeper = TriangleMesh::TriangleOf(closedMesh.Opposite[h]);
    }
  }
  return annotation;
}
}
