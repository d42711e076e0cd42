// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TestShapes_h
#define marrow_TestShapes_h

#include "Constants.h"
#include "TriangleMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

/// Shapes whose measures are known in closed form, and the changes under which a measure must not
/// change. Every mesh comes with its connectivity built, closed and oriented outward.
namespace marrow::test
{
/// A cylinder about the z axis, from -length/2 to length/2, with flat caps of concentric rings.
inline TriangleMesh MakeCylinder(double radius, double length, int around, int along)
{
  TriangleMesh mesh;
  const int capRings = std::max(1, around / 6);
  // Rings from the middle of the lower cap over the side to the middle of the upper cap.
  std::vector<std::pair<double, double>> profile;
  for (int i = 1; i <= capRings; ++i)
  {
    profile.push_back({ radius * i / capRings, -0.5 * length });
  }
  for (int i = 1; i <= along; ++i)
  {
    profile.push_back({ radius, length * (static_cast<double>(i) / along - 0.5) });
  }
  for (int i = capRings - 1; i >= 1; --i)
  {
    profile.push_back({ radius * i / capRings, 0.5 * length });
  }
  const int rings = static_cast<int>(profile.size());
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      // Every other ring turned by half a step: nearly equilateral triangles.
      const double angle = 2.0 * Pi * (j + 0.5 * (i % 2)) / around;
      mesh.Points.push_back({ profile[i].first * std::cos(angle),
        profile[i].first * std::sin(angle), profile[i].second });
    }
  }
  const int low = static_cast<int>(mesh.Points.size());
  mesh.Points.push_back({ 0.0, 0.0, -0.5 * length });
  const int high = low + 1;
  mesh.Points.push_back({ 0.0, 0.0, 0.5 * length });
  for (int j = 0; j < around; ++j)
  {
    const int next = (j + 1) % around;
    mesh.Triangles.push_back({ low, next, j });
    for (int i = 0; i + 1 < rings; ++i)
    {
      const int a = i * around + j;
      const int b = i * around + next;
      const int c = (i + 1) * around + j;
      const int d = (i + 1) * around + next;
      if (i % 2 == 0)
      {
        mesh.Triangles.push_back({ a, b, c });
        mesh.Triangles.push_back({ b, d, c });
      }
      else
      {
        mesh.Triangles.push_back({ a, d, c });
        mesh.Triangles.push_back({ a, b, d });
      }
    }
    mesh.Triangles.push_back({ high, (rings - 1) * around + j, (rings - 1) * around + next });
  }
  mesh.BuildConnectivity();
  return mesh;
}

/// A torus about the z axis: `radius` from the axis to the middle of the tube, `tube` its radius.
inline TriangleMesh MakeTorus(double radius, double tube, int around, int aroundTube)
{
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    const double u = 2.0 * Pi * i / around;
    for (int j = 0; j < aroundTube; ++j)
    {
      const double v = 2.0 * Pi * j / aroundTube;
      const double distance = radius + tube * std::cos(v);
      mesh.Points.push_back({ distance * std::cos(u), distance * std::sin(u), tube * std::sin(v) });
    }
  }
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < aroundTube; ++j)
    {
      const int a = i * aroundTube + j;
      const int b = ((i + 1) % around) * aroundTube + j;
      const int c = ((i + 1) % around) * aroundTube + (j + 1) % aroundTube;
      const int d = i * aroundTube + (j + 1) % aroundTube;
      mesh.Triangles.push_back({ a, b, c });
      mesh.Triangles.push_back({ a, c, d });
    }
  }
  mesh.BuildConnectivity();
  return mesh;
}

/// An octahedron whose triangles are cut in four `subdivisions` times: 8 * 4^subdivisions
/// triangles.
inline TriangleMesh MakeSphere(double radius, int subdivisions)
{
  TriangleMesh mesh;
  mesh.Points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  mesh.Triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  for (int level = 0; level < subdivisions; ++level)
  {
    std::map<std::pair<int, int>, int> middles;
    auto middle = [&](int a, int b)
    {
      const std::pair<int, int> key(std::min(a, b), std::max(a, b));
      const auto found = middles.find(key);
      if (found != middles.end())
      {
        return found->second;
      }
      mesh.Points.push_back((mesh.Points[a] + mesh.Points[b]).normalized());
      return middles[key] = mesh.NumberOfVertices() - 1;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& t : mesh.Triangles)
    {
      const int ab = middle(t[0], t[1]);
      const int bc = middle(t[1], t[2]);
      const int ca = middle(t[2], t[0]);
      finer.push_back({ t[0], ab, ca });
      finer.push_back({ ab, t[1], bc });
      finer.push_back({ ca, bc, t[2] });
      finer.push_back({ ab, bc, ca });
    }
    mesh.Triangles = finer;
  }
  for (auto& point : mesh.Points)
  {
    point *= radius;
  }
  mesh.BuildConnectivity();
  return mesh;
}

/// Positive for a closed mesh that is oriented outward.
inline double SignedVolume(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    volume += mesh.Points[t[0]].dot(mesh.Points[t[1]].cross(mesh.Points[t[2]])) / 6.0;
  }
  return volume;
}

inline TriangleMesh Rotated(TriangleMesh mesh, const Eigen::Vector3d& axis, double angle)
{
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  for (auto& point : mesh.Points)
  {
    point = rotation * point;
  }
  return mesh;
}

inline TriangleMesh Scaled(TriangleMesh mesh, double factor)
{
  for (auto& point : mesh.Points)
  {
    point *= factor;
  }
  return mesh;
}

inline TriangleMesh Translated(TriangleMesh mesh, const Eigen::Vector3d& offset)
{
  for (auto& point : mesh.Points)
  {
    point += offset;
  }
  return mesh;
}

/// 0 ... size-1 in an order given by the seed; the same on every machine.
inline std::vector<int> RandomOrder(int size, unsigned int seed)
{
  std::vector<int> order(size);
  for (int i = 0; i < size; ++i)
  {
    order[i] = i;
  }
  std::mt19937 random(seed);
  for (int i = size - 1; i > 0; --i)
  {
    std::swap(order[i], order[random() % static_cast<unsigned int>(i + 1)]);
  }
  return order;
}

/// A mesh with its vertices and triangles renumbered and the corners of each triangle rotated.
struct PermutedMesh
{
  TriangleMesh Mesh;
  std::vector<int> OldVertex;   ///< per new vertex
  std::vector<int> OldTriangle; ///< per new triangle
};

inline PermutedMesh Permuted(const TriangleMesh& mesh, unsigned int seed)
{
  PermutedMesh result;
  result.OldVertex = RandomOrder(mesh.NumberOfVertices(), seed);
  result.OldTriangle = RandomOrder(mesh.NumberOfTriangles(), seed + 1);
  std::vector<int> newVertex(result.OldVertex.size());
  for (std::size_t i = 0; i < newVertex.size(); ++i)
  {
    newVertex[result.OldVertex[i]] = static_cast<int>(i);
    result.Mesh.Points.push_back(mesh.Points[result.OldVertex[i]]);
  }
  for (int old : result.OldTriangle)
  {
    const auto& t = mesh.Triangles[old];
    const int shift = old % 3;
    result.Mesh.Triangles.push_back(
      { newVertex[t[shift]], newVertex[t[(shift + 1) % 3]], newVertex[t[(shift + 2) % 3]] });
  }
  result.Mesh.BuildConnectivity();
  return result;
}
}

#endif
