// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollapseComplex_h
#define marrow_CollapseComplex_h

#include "HomologyAnnotation.h"
#include "TriangleMesh.h"

#include <boost/container/small_vector.hpp>

#include <vector>

namespace marrow
{
/// The vertices, edges and triangles of a mesh while its edges are collapsed. It need not stay a
/// manifold: sheets fall together into one, and in the end only edges are left. Every edge keeps its
/// homology annotation, so that it is known at any time which loops bound.
class CollapseComplex
{
public:
  // A small vector that is moved throws nothing; clang-tidy takes its copy for that.
  struct Edge // NOLINT(bugprone-exception-escape)
  {
    int A;
    int B;
    bool Alive;
    boost::container::small_vector<int, 4> Apexes; ///< the third vertices of its triangles
    HomologyClass Class;
  };
  struct Spoke
  {
    int Neighbor;
    int Edge;
  };

  using SpokeList = boost::container::small_vector<Spoke, 8>;

  explicit CollapseComplex(const TriangleMesh& closedMesh);

  int NumberOfVertices() const { return static_cast<int>(this->Spokes.size()); }
  int NumberOfEdges() const { return static_cast<int>(this->Edges.size()); }
  int NumberOfTriangles() const { return this->TriangleCount; }
  /// Half the rank of the homology at the start: the number of loops that may be closed.
  int Genus() const { return this->GenusAtStart; }
  int NumberOfClosedLoops() const { return this->ClosedLoops; }

  bool IsAlive(int vertex) const { return this->Alive[vertex]; }
  const Edge& EdgeAt(int edge) const { return this->Edges[edge]; }
  const SpokeList& SpokesOf(int vertex) const { return this->Spokes[vertex]; }
  /// The vertices that were merged into `vertex`, itself among them.
  const std::vector<int>& MergedInto(int vertex) const { return this->Merged[vertex]; }
  int FindEdge(int a, int b) const;

  /// The common neighbours k of both ends whose loop a, b, k does not bound: it would be closed.
  std::vector<int> ThirdsOfOpenLoops(int a, int b, int edge) const;

  /// Merges `from` into `to` along `edge`.
  void Collapse(int from, int to, int edge);

  /// The edges of the skeleton: all that are alive, if no triangle is left and as many loops were
  /// closed as the genus, as it nearly always is. Else a shortest spanning forest, and of the edges
  /// that close independent loops with it the genus with the longest ones.
  std::vector<int> GraphEdges(const std::vector<Eigen::Vector3d>& position) const;

private:
  void MoveTriangles(int from, int to);
  void CloseLoop(const HomologyClass& loop);
  void RemoveSpoke(int vertex, int neighbor);

  std::vector<Edge> Edges;
  std::vector<SpokeList> Spokes;
  std::vector<std::vector<int>> Merged;
  std::vector<char> Alive;
  int TriangleCount = 0;
  int GenusAtStart = 0;
  int ClosedLoops = 0;
};
}

#endif
