// SPDX-License-Identifier: BSD-3-Clause
#include "MeshRelaxation.h"

#include "Constants.h"
#include "ParallelFor.h"

#include <Eigen/Geometry>

#include <cmath>

namespace marrow
{
namespace
{
double Angle(const Eigen::Vector3d& apex, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d u = a - apex;
  const Eigen::Vector3d v = b - apex;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

Eigen::Vector3d Normal(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return (b - a).cross(c - a).normalized();
}

int Valence(const TriangleMesh& mesh, int vertex)
{
  int valence = 0;
  mesh.ForEachNeighbor(vertex, [&](int) { ++valence; });
  return valence;
}

/// Whether the edge of half-edge h should be the other diagonal of its two triangles, and may be.
bool ShouldFlip(const TriangleMesh& mesh, int h)
{
  const int a = mesh.From(h);
  const int b = mesh.To(h);
  const int c = mesh.From(TriangleMesh::Previous(h));
  const int d = mesh.From(TriangleMesh::Previous(mesh.Opposite[h]));
  const auto& p = mesh.Points;
  if (Angle(p[c], p[a], p[b]) + Angle(p[d], p[a], p[b]) <= Pi + 1e-6)
  {
    return false;
  }
  if (Valence(mesh, a) <= 3 || Valence(mesh, b) <= 3)
  {
    return false;
  }
  bool connected = false;
  mesh.ForEachNeighbor(c, [&](int neighbor) { connected |= neighbor == d; });
  if (connected)
  {
    return false;
  }
  // No fold: the new triangles must look where the old ones did.
  const Eigen::Vector3d old = Normal(p[a], p[b], p[c]) + Normal(p[b], p[a], p[d]);
  return Normal(p[d], p[b], p[c]).dot(old) > 1.0 && Normal(p[c], p[a], p[d]).dot(old) > 1.0;
}

void Flip(TriangleMesh& mesh, int h)
{
  const int o = mesh.Opposite[h];
  const int t = TriangleMesh::TriangleOf(h);
  const int s = TriangleMesh::TriangleOf(o);
  const int a = mesh.From(h);
  const int b = mesh.To(h);
  const int c = mesh.From(TriangleMesh::Previous(h));
  const int d = mesh.From(TriangleMesh::Previous(o));
  const int outsideBC = mesh.Opposite[TriangleMesh::Next(h)];
  const int outsideCA = mesh.Opposite[TriangleMesh::Previous(h)];
  const int outsideAD = mesh.Opposite[TriangleMesh::Next(o)];
  const int outsideDB = mesh.Opposite[TriangleMesh::Previous(o)];

  auto pair = [&mesh](int x, int y)
  {
    mesh.Opposite[x] = y;
    mesh.Opposite[y] = x;
  };
  mesh.Triangles[t] = { d, b, c };
  mesh.Triangles[s] = { c, a, d };
  pair(3 * t, outsideDB);
  pair(3 * t + 1, outsideBC);
  pair(3 * s, outsideCA);
  pair(3 * s + 1, outsideAD);
  pair(3 * t + 2, 3 * s + 2);
  mesh.Outgoing[a] = 3 * s + 1;
  mesh.Outgoing[b] = 3 * t + 1;
  mesh.Outgoing[c] = 3 * t + 2;
  mesh.Outgoing[d] = 3 * t;
}

void FlipEdges(TriangleMesh& mesh)
{
  constexpr int MaximumSweeps = 5;
  for (int sweep = 0; sweep < MaximumSweeps; ++sweep)
  {
    int flips = 0;
    for (int h = 0; h < static_cast<int>(mesh.Opposite.size()); ++h)
    {
      if (h < mesh.Opposite[h] && ShouldFlip(mesh, h))
      {
        Flip(mesh, h);
        ++flips;
      }
    }
    if (flips == 0)
    {
      return;
    }
  }
}
}

void RelaxMesh(TriangleMesh& mesh,
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& project, int rounds)
{
  ParallelFor(0, mesh.NumberOfVertices(),
    [&](int first, int last)
    {
      for (int v = first; v < last; ++v)
      {
        mesh.Points[v] = project(mesh.Points[v]);
      }
    });
  for (int round = 0; round < rounds; ++round)
  {
    FlipEdges(mesh);
    const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
    std::vector<Eigen::Vector3d> moved(mesh.Points.size());
    ParallelFor(0, mesh.NumberOfVertices(),
      [&](int first, int last)
      {
        for (int v = first; v < last; ++v)
        {
          Eigen::Vector3d mean = Eigen::Vector3d::Zero();
          int count = 0;
          mesh.ForEachNeighbor(v,
            [&](int neighbor)
            {
              mean += mesh.Points[neighbor];
              ++count;
            });
          const Eigen::Vector3d step = 0.6 * (mean / count - mesh.Points[v]);
          moved[v] = project(mesh.Points[v] + step - step.dot(normals[v]) * normals[v]);
        }
      });
    mesh.Points = std::move(moved);
  }
  FlipEdges(mesh);
}
}
