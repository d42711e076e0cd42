// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentLoops.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace marrow
{
namespace
{
struct TracedLoop
{
  SegmentLoop Loop;
  bool OneNeighbour = true;
};

/// All border loops of all pieces, each traced with its piece on the left.
std::vector<TracedLoop> TraceLoops(const TriangleMesh& mesh, const SegmentPieces& pieces)
{
  const auto isBoundary = [&](int h)
  {
    const int opposite = mesh.Opposite[h];
    return opposite < 0 ||
      pieces.PieceOfTriangle[TriangleMesh::TriangleOf(opposite)] !=
      pieces.PieceOfTriangle[TriangleMesh::TriangleOf(h)];
  };
  std::vector<TracedLoop> loops;
  std::vector<bool> visited(mesh.Opposite.size(), false);
  for (int start = 0; start < static_cast<int>(mesh.Opposite.size()); ++start)
  {
    if (visited[start] || !isBoundary(start))
    {
      continue;
    }
    TracedLoop traced;
    std::map<int, int> neighbours;
    bool onMeshBorder = false;
    int h = start;
    while (!visited[h])
    {
      visited[h] = true;
      traced.Loop.HalfEdges.push_back(h);
      const int opposite = mesh.Opposite[h];
      if (opposite < 0)
      {
        onMeshBorder = true;
      }
      else
      {
        ++neighbours[pieces.PieceOfTriangle[TriangleMesh::TriangleOf(opposite)]];
      }
      h = TriangleMesh::Next(h);
      while (!isBoundary(h))
      {
        h = TriangleMesh::Next(mesh.Opposite[h]);
      }
    }
    if (onMeshBorder || traced.Loop.HalfEdges.size() < 3)
    {
      continue;
    }
    traced.Loop.LeftPiece = pieces.PieceOfTriangle[TriangleMesh::TriangleOf(start)];
    traced.Loop.RightPiece = std::max_element(neighbours.begin(), neighbours.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
    traced.OneNeighbour = neighbours.size() == 1;
    loops.push_back(std::move(traced));
  }
  return loops;
}
}

SegmentPieces FindPieces(const TriangleMesh& mesh, const std::vector<int>& labels)
{
  SegmentPieces pieces;
  pieces.PieceOfTriangle.assign(mesh.NumberOfTriangles(), -1);
  std::vector<int> stack;
  for (int first = 0; first < mesh.NumberOfTriangles(); ++first)
  {
    if (pieces.PieceOfTriangle[first] >= 0)
    {
      continue;
    }
    const int piece = pieces.NumberOfPieces();
    pieces.LabelOfPiece.push_back(labels[first]);
    pieces.AreaOfPiece.push_back(0.0);
    pieces.PieceOfTriangle[first] = piece;
    stack.assign(1, first);
    while (!stack.empty())
    {
      const int triangle = stack.back();
      stack.pop_back();
      pieces.AreaOfPiece[piece] += mesh.Area(triangle);
      for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
      {
        const int opposite = mesh.Opposite[h];
        const int next = opposite < 0 ? -1 : TriangleMesh::TriangleOf(opposite);
        if (next >= 0 && pieces.PieceOfTriangle[next] < 0 && labels[next] == labels[first])
        {
          pieces.PieceOfTriangle[next] = piece;
          stack.push_back(next);
        }
      }
    }
  }
  return pieces;
}

std::vector<int> SegmentLoop::Vertices(const TriangleMesh& mesh) const
{
  std::vector<int> vertices;
  vertices.reserve(this->HalfEdges.size());
  for (int h : this->HalfEdges)
  {
    vertices.push_back(mesh.From(h));
  }
  return vertices;
}

std::vector<SegmentLoop> FindLoops(const TriangleMesh& mesh, const SegmentPieces& pieces)
{
  std::vector<TracedLoop> traced = TraceLoops(mesh, pieces);
  std::vector<int> order(traced.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      if (traced[a].OneNeighbour != traced[b].OneNeighbour)
      {
        return traced[a].OneNeighbour;
      }
      return pieces.AreaOfPiece[traced[a].Loop.LeftPiece] <
        pieces.AreaOfPiece[traced[b].Loop.LeftPiece];
    });

  std::vector<SegmentLoop> loops;
  std::vector<bool> covered(mesh.Opposite.size(), false);
  for (int i : order)
  {
    const SegmentLoop& loop = traced[i].Loop;
    const auto known = std::count_if(
      loop.HalfEdges.begin(), loop.HalfEdges.end(), [&](int h) { return covered[h]; });
    if (2 * known > static_cast<std::ptrdiff_t>(loop.HalfEdges.size()))
    {
      continue;
    }
    for (int h : loop.HalfEdges)
    {
      covered[h] = true;
      covered[mesh.Opposite[h]] = true;
    }
    loops.push_back(loop);
  }
  return loops;
}
}
