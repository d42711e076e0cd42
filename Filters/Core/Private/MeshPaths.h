// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshPaths_h
#define marrow_MeshPaths_h

#include "TriangleMesh.h"

#include <functional>
#include <limits>
#include <vector>

namespace marrow
{
/// Shortest edge paths from a set of seeds.
struct PathField
{
  std::vector<double> Distance; ///< infinite where not reached
  std::vector<int> Origin;      ///< the seed that a vertex was reached from, -1 if none
  std::vector<int> Previous;    ///< the vertex before it on that path, -1 at seeds
};

/// Dijkstra over mesh edges as far as `limit`. Ties go to the smaller vertex number.
PathField DistanceField(const TriangleMesh& mesh, const std::vector<int>& seeds,
  double limit = std::numeric_limits<double>::infinity());

/// Shortest paths between a few vertices, again and again on one mesh: keeps its buffers, so that a
/// short path costs only what it touches.
class PathFinder
{
public:
  explicit PathFinder(const TriangleMesh& mesh);

  /// Cost of a mesh edge from one vertex to the other; infinite forbids it.
  using Cost = std::function<double(int from, int to)>;
  /// The vertices of the cheapest path from one of `starts` to the first vertex that `isGoal`
  /// accepts, both included; empty if there is none.
  std::vector<int> Find(
    const std::vector<int>& starts, const std::function<bool(int)>& isGoal, const Cost& cost);

private:
  const TriangleMesh& Mesh;
  std::vector<double> Distance;
  std::vector<int> Previous;
  std::vector<int> Touched;
};
}

#endif
