// SPDX-License-Identifier: BSD-3-Clause
#include "FanSeparation.h"

#include "EdgeGroups.h"

#include <algorithm>

namespace marrow
{
namespace
{
/// Numbers the fans: the corner at the start of every half-edge gets the vertex of its fan.
int NumberFans(MendedMesh& mesh)
{
  TriangleMesh& triangles = mesh.Mesh;
  const int numberOfHalfEdges = 3 * triangles.NumberOfTriangles();
  std::vector<char> seen(numberOfHalfEdges, 0);
  std::vector<char> taken(triangles.Points.size(), 0);
  int added = 0;
  std::vector<int> fan;
  for (int h = 0; h < numberOfHalfEdges; ++h)
  {
    if (seen[h])
    {
      continue;
    }
    fan.clear();
    int walk = h;
    while (walk >= 0 && !seen[walk])
    {
      seen[walk] = 1;
      fan.push_back(walk);
      walk = triangles.Opposite[TriangleMesh::Previous(walk)];
    }
    // Up to a border: then also the other way.
    walk = walk < 0 ? triangles.Opposite[h] : -1;
    while (walk >= 0)
    {
      walk = TriangleMesh::Next(walk);
      seen[walk] = 1;
      fan.push_back(walk);
      walk = triangles.Opposite[walk];
    }
    const int vertex = triangles.From(h);
    if (!taken[vertex])
    {
      taken[vertex] = 1;
      continue;
    }
    const int copy = triangles.NumberOfVertices();
    triangles.Points.push_back(Eigen::Vector3d(triangles.Points[vertex]));
    mesh.PointOfVertex.push_back(mesh.PointOfVertex[vertex]);
    ++added;
    for (int corner : fan)
    {
      triangles.Triangles[corner / 3][corner % 3] = copy;
    }
  }
  return added;
}

/// Cuts the triangle of a half-edge in two from `middle` on it. The half-edge keeps its first half;
/// returns the half-edge of the second.
int CutTriangle(MendedMesh& mesh, int h, int middle)
{
  TriangleMesh& triangles = mesh.Mesh;
  const int added = triangles.NumberOfTriangles();
  const int next = TriangleMesh::Next(h);
  const int to = triangles.To(h);
  const int apex = triangles.To(next);
  triangles.Triangles.push_back({ middle, to, apex });
  mesh.CellOfTriangle.push_back(mesh.CellOfTriangle[h / 3]);
  triangles.Triangles[next / 3][next % 3] = middle;
  const int beyond = triangles.Opposite[next];
  triangles.Opposite.insert(triangles.Opposite.end(), { -1, beyond, next });
  if (beyond >= 0)
  {
    triangles.Opposite[beyond] = 3 * added + 1;
  }
  triangles.Opposite[next] = 3 * added + 2;
  return 3 * added;
}

void CutEdge(MendedMesh& mesh, int h)
{
  TriangleMesh& triangles = mesh.Mesh;
  const int middle = triangles.NumberOfVertices();
  const int from = triangles.From(h);
  triangles.Points.push_back(0.5 * (triangles.Points[from] + triangles.Points[triangles.To(h)]));
  mesh.PointOfVertex.push_back(mesh.PointOfVertex[from]);
  const int g = triangles.Opposite[h];
  const int secondOfH = CutTriangle(mesh, h, middle);
  if (g >= 0)
  {
    const int secondOfG = CutTriangle(mesh, g, middle);
    triangles.Opposite[h] = secondOfG;
    triangles.Opposite[secondOfG] = h;
    triangles.Opposite[g] = secondOfH;
    triangles.Opposite[secondOfH] = g;
  }
}

/// One round: edges whose triangles another cut of the round has touched wait for the next.
int CutSharedEdges(MendedMesh& mesh)
{
  const EdgeGroups edges(mesh.Mesh);
  std::vector<char> touched(mesh.Mesh.Triangles.size(), 0);
  int cut = 0;
  for (int e = 0; e < edges.NumberOfEdges(); ++e)
  {
    const int* first = edges.begin(e);
    if (edges.SizeOf(e) == 1 || (edges.SizeOf(e) == 2 && mesh.Mesh.Opposite[first[0]] == first[1]))
    {
      continue;
    }
    if (std::any_of(first, edges.end(e), [&](int h) { return touched[h / 3] != 0; }))
    {
      continue;
    }
    const int keptPartner = mesh.Mesh.Opposite[*first];
    for (const int* h = first + 1; h != edges.end(e); ++h)
    {
      const int partner = mesh.Mesh.Opposite[*h];
      if (*h == keptPartner || (partner >= 0 && partner < *h))
      {
        continue;
      }
      if (!touched[*h / 3] && (partner < 0 || !touched[partner / 3]))
      {
        touched[*h / 3] = 1;
        if (partner >= 0)
        {
          touched[partner / 3] = 1;
        }
        CutEdge(mesh, *h);
        ++cut;
      }
    }
  }
  return cut;
}
}

int SeparateFans(MendedMesh& mesh)
{
  const int before = mesh.Mesh.NumberOfVertices();
  NumberFans(mesh);
  while (CutSharedEdges(mesh) > 0)
  {
  }
  TriangleMesh& triangles = mesh.Mesh;
  triangles.Outgoing.assign(triangles.Points.size(), -1);
  for (int h = 0; h < 3 * triangles.NumberOfTriangles(); ++h)
  {
    const int vertex = triangles.From(h);
    if (triangles.Outgoing[vertex] < 0 || triangles.Opposite[h] < 0)
    {
      triangles.Outgoing[vertex] = h;
    }
  }
  return triangles.NumberOfVertices() - before;
}
}
