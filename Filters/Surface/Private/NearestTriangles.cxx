// SPDX-License-Identifier: BSD-3-Clause
#include "NearestTriangles.h"

#include "NearestDownhill.h"

#include <algorithm>

namespace marrow
{
void FindNearest(const TriangleMesh& mesh, SimplifiedMesh& simplified)
{
  const TriangleMesh& target = simplified.Mesh;
  const NearestDownhill nearestDownhill(target);
  std::vector<int>& triangleOfOld = simplified.TriangleOfOld;
  const auto isSame = [&](int old, int own)
  {
    const auto& corners = target.Triangles[own];
    return std::equal(corners.begin(), corners.end(), mesh.Triangles[old].begin(),
      [&](int corner, int oldCorner) { return simplified.OldVertex[corner] == oldCorner; });
  };
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    // From itself, from where a neighbour was found, or from what its first corner was drawn into.
    int from = triangleOfOld[t];
    if (from >= 0 && isSame(t, from))
    {
      continue;
    }
    for (int h = 3 * t; from < 0 && h < 3 * t + 3; ++h)
    {
      from = mesh.Opposite[h] >= 0 ? triangleOfOld[TriangleMesh::TriangleOf(mesh.Opposite[h])] : -1;
    }
    if (from < 0)
    {
      from =
        TriangleMesh::TriangleOf(target.Outgoing[simplified.VertexOfOld[mesh.Triangles[t][0]]]);
    }
    triangleOfOld[t] = nearestDownhill.Find(mesh.Centroid(t), from);
  }
  // The survivor may have come from further away than a corner of the nearest triangle.
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    int& nearest = simplified.VertexOfOld[v];
    if (nearest < 0 || simplified.OldVertex[nearest] == v)
    {
      continue;
    }
    for (int corner : target.Triangles[triangleOfOld[TriangleMesh::TriangleOf(mesh.Outgoing[v])]])
    {
      if ((target.Points[corner] - mesh.Points[v]).squaredNorm() <
        (target.Points[nearest] - mesh.Points[v]).squaredNorm())
      {
        nearest = corner;
      }
    }
  }
}
}
