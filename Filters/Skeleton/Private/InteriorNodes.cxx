// SPDX-License-Identifier: BSD-3-Clause
#include "InteriorNodes.h"

#include "ParallelFor.h"
#include "WindingNumber.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace marrow
{
namespace
{
/// Per node: whether the ray along `axis` leaves the mesh an odd number of times. The nodes are sorted by
/// one coordinate, so that a triangle meets only those that lie below its shadow.
std::vector<char> OddCrossings(const Skeleton& skeleton, const TriangleMesh& mesh, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const int numberOfNodes = skeleton.NumberOfNodes();
  std::vector<int> order(numberOfNodes);
  std::iota(order.begin(), order.end(), 0);
  const auto coordinate = [&](int node) { return skeleton.Graph[node].Position[u]; };
  std::sort(
    order.begin(), order.end(), [&](int a, int b) { return coordinate(a) < coordinate(b); });
  std::vector<double> sorted(numberOfNodes);
  std::transform(order.begin(), order.end(), sorted.begin(), coordinate);

  std::vector<char> odd(numberOfNodes, 0);
  for (const auto& triangle : mesh.Triangles)
  {
    const Eigen::Vector3d& p = mesh.Points[triangle[0]];
    const Eigen::Vector3d& q = mesh.Points[triangle[1]];
    const Eigen::Vector3d& r = mesh.Points[triangle[2]];
    const double lowU = std::min({ p[u], q[u], r[u] });
    const double highU = std::max({ p[u], q[u], r[u] });
    const double lowV = std::min({ p[v], q[v], r[v] });
    const double highV = std::max({ p[v], q[v], r[v] });
    const auto first = std::lower_bound(sorted.begin(), sorted.end(), lowU);
    for (auto i = first - sorted.begin(); i < numberOfNodes && sorted[i] <= highU; ++i)
    {
      const Eigen::Vector3d& node = skeleton.Graph[order[i]].Position;
      if (node[v] < lowV || node[v] > highV)
      {
        continue;
      }
      const Eigen::Vector3d a = p - node;
      const Eigen::Vector3d b = q - node;
      const Eigen::Vector3d c = r - node;
      // The origin lies in the projected triangle if the three edge functions have one sign.
      const double ab = a[u] * b[v] - a[v] * b[u];
      const double bc = b[u] * c[v] - b[v] * c[u];
      const double ca = c[u] * a[v] - c[v] * a[u];
      if ((ab > 0.0) != (bc > 0.0) || (bc > 0.0) != (ca > 0.0))
      {
        continue;
      }
      const double height = a[axis] * bc + b[axis] * ca + c[axis] * ab;
      odd[order[i]] ^= static_cast<char>((height > 0.0) == (ab > 0.0));
    }
  }
  return odd;
}

/// The distance from a vertex straight inwards to the opposite wall, infinite if there is none.
double Thickness(const TriangleMesh& mesh, int vertex, const Eigen::Vector3d& inwards)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.Triangles)
  {
    if (triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex)
    {
      continue;
    }
    const Eigen::Vector3d a = mesh.Points[triangle[0]];
    const Eigen::Vector3d ab = mesh.Points[triangle[1]] - a;
    const Eigen::Vector3d ac = mesh.Points[triangle[2]] - a;
    const Eigen::Vector3d from = mesh.Points[vertex] - a;
    const Eigen::Vector3d p = inwards.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0.0)
    {
      continue;
    }
    const double u = from.dot(p) / determinant;
    const Eigen::Vector3d q = from.cross(ab);
    const double v = inwards.dot(q) / determinant;
    const double t = ac.dot(q) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0)
    {
      nearest = std::min(nearest, t);
    }
  }
  return nearest;
}

Eigen::Vector3d NearestInside(
  const SkeletonNode& node, const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& normals)
{
  // In the middle of the wall below one of the nearest vertices.
  constexpr int Samples = 4;
  std::vector<int> order = node.Vertices;
  if (order.empty())
  {
    order.resize(mesh.Points.size());
    std::iota(order.begin(), order.end(), 0);
  }
  const auto distance = [&](int v) { return (mesh.Points[v] - node.Position).squaredNorm(); };
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return distance(a) != distance(b) ? distance(a) < distance(b) : a < b; });
  for (int i = 0; i < Samples; ++i)
  {
    // From near to far; half of φ at most, or as many vertices as are likely to be of one ring.
    const std::size_t reach = std::min<std::size_t>(order.size(), 64);
    const int v = order[reach * i / (2 * Samples)];
    const double thickness = Thickness(mesh, v, -normals[v]);
    const Eigen::Vector3d candidate = mesh.Points[v] - 0.5 * thickness * normals[v];
    if (std::isfinite(thickness) && WindingNumber(mesh, candidate) > 0.5)
    {
      return candidate;
    }
  }
  return node.Position;
}
}

void MoveNodesInside(Skeleton& skeleton, const TriangleMesh& mesh)
{
  // The rays are cheap, and wrong only where one grazes an edge: a node that one of them says is outside
  // is looked at again.
  std::array<std::vector<char>, 3> odd;
  ParallelFor(0, 3,
    [&](int first, int last)
    {
      for (int axis = first; axis < last; ++axis)
      {
        odd[axis] = OddCrossings(skeleton, mesh, axis);
      }
    });
  std::vector<int> doubtful;
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    if (!odd[0][n] || !odd[1][n] || !odd[2][n])
    {
      doubtful.push_back(n);
    }
  }
  if (doubtful.empty())
  {
    return;
  }
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  ParallelFor(0, static_cast<int>(doubtful.size()),
    [&](int first, int last)
    {
      for (int i = first; i < last; ++i)
      {
        SkeletonNode& node = skeleton.Graph[doubtful[i]];
        if (WindingNumber(mesh, node.Position) < 0.5)
        {
          node.Position = NearestInside(node, mesh, normals);
        }
      }
    });
  skeleton.UpdateArcLengths();
}
}
