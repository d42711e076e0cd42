// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeasureShapes_h
#define marrow_MeasureShapes_h

#include "TestShapes.h"

namespace marrow::test
{
/// An egg without any symmetry, convex, closed: no two directions and no two places are alike, so
/// that no measure hangs on a tie.
inline TriangleMesh MakeEgg(int subdivisions)
{
  TriangleMesh mesh = MakeSphere(1.0, subdivisions);
  for (auto& p : mesh.Points)
  {
    const double z = 2.6 * p.z();
    p = { p.x() * (1.0 + 0.08 * z) + 0.05 * z + 0.13 * p.y(),
      p.y() * (1.5 - 0.1 * z + 0.05 * p.x()), z };
  }
  return mesh;
}

/// The mesh without the triangles for which `drop(mesh, triangle)` is true; points stay.
template <typename Drop>
TriangleMesh Without(const TriangleMesh& mesh, Drop&& drop)
{
  TriangleMesh result;
  result.Points = mesh.Points;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (!drop(mesh, t))
    {
      result.Triangles.push_back(mesh.Triangles[t]);
    }
  }
  result.BuildConnectivity();
  return result;
}

/// Two meshes in one, the second after the first.
inline TriangleMesh Joined(TriangleMesh first, const TriangleMesh& second)
{
  const int offset = first.NumberOfVertices();
  first.Points.insert(first.Points.end(), second.Points.begin(), second.Points.end());
  for (const auto& t : second.Triangles)
  {
    first.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
  first.BuildConnectivity();
  return first;
}
}

#endif
