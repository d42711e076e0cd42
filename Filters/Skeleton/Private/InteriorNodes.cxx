// SPDX-License-Identifier: BSD-3-Clause
#include "InteriorNodes.h"

#include "ParallelFor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
/// A node that sees more than this share of its φ from outside is examined.
constexpr double DoubtfulShare = 0.15;

bool IsDoubtful(const SkeletonNode& node, const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& normals)
{
  int outside = 0;
  for (const int v : node.Vertices)
  {
    outside += (mesh.Points[v] - node.Position).dot(normals[v]) <= 0.0;
  }
  return outside > DoubtfulShare * static_cast<double>(node.Vertices.size());
}

Eigen::Vector3d NearestInside(const SkeletonNode& node, const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& normals)
{
  // A handful of the nearest vertices, evenly from near to far, each at several depths.
  constexpr int Samples = 6;
  std::vector<int> order = node.Vertices;
  const auto distance = [&](int v) { return (mesh.Points[v] - node.Position).squaredNorm(); };
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return distance(a) != distance(b) ? distance(a) < distance(b) : a < b; });
  const double radius = std::sqrt(distance(order[order.size() / 2]));
  for (const double depth : { 0.5, 0.25, 0.12, 0.06, 0.03 })
  {
    Eigen::Vector3d best = node.Position;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < Samples; ++i)
    {
      const int v = order[order.size() * i / Samples];
      const Eigen::Vector3d candidate = mesh.Points[v] - depth * radius * normals[v];
      const double away = (candidate - node.Position).squaredNorm();
      if (away < nearest && WindingNumber(mesh, candidate) > 0.5)
      {
        nearest = away;
        best = candidate;
      }
    }
    if (nearest < std::numeric_limits<double>::infinity())
    {
      return best;
    }
  }
  return node.Position;
}
}

double WindingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point)
{
  double solidAngle = 0.0;
  for (const auto& triangle : mesh.Triangles)
  {
    const Eigen::Vector3d a = mesh.Points[triangle[0]] - point;
    const Eigen::Vector3d b = mesh.Points[triangle[1]] - point;
    const Eigen::Vector3d c = mesh.Points[triangle[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    solidAngle += 2.0 * std::atan2(numerator, denominator);
  }
  return solidAngle / (4.0 * Pi);
}

void MoveNodesInside(Skeleton& skeleton, const TriangleMesh& mesh)
{
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  ParallelFor(0, skeleton.NumberOfNodes(),
    [&](int first, int last)
    {
      for (int n = first; n < last; ++n)
      {
        SkeletonNode& node = skeleton.Graph[n];
        if (!node.Vertices.empty() && IsDoubtful(node, mesh, normals) &&
          WindingNumber(mesh, node.Position) < 0.5)
        {
          node.Position = NearestInside(node, mesh, normals);
        }
      }
    });
  skeleton.UpdateArcLengths();
}
}
