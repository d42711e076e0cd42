// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceMending.h"

#include "FaceOrientation.h"
#include "FaceRemoval.h"
#include "FanSeparation.h"
#include "FlatTriangles.h"
#include "HoleFilling.h"
#include "PointWelding.h"
#include "PolygonTriangulation.h"
#include "SheetPairing.h"

#include <algorithm>

namespace marrow
{
namespace
{
/// Drops the vertices that no triangle uses; the others keep their order.
void RemoveUnusedVertices(MendedMesh& mesh)
{
  TriangleMesh& triangles = mesh.Mesh;
  if (std::find(triangles.Outgoing.begin(), triangles.Outgoing.end(), -1) ==
    triangles.Outgoing.end())
  {
    return;
  }
  std::vector<int> newVertex(triangles.Points.size(), -1);
  int kept = 0;
  for (int v = 0; v < triangles.NumberOfVertices(); ++v)
  {
    if (triangles.Outgoing[v] >= 0)
    {
      newVertex[v] = kept;
      triangles.Points[kept] = Eigen::Vector3d(triangles.Points[v]);
      triangles.Outgoing[kept] = triangles.Outgoing[v];
      mesh.PointOfVertex[kept] = mesh.PointOfVertex[v];
      ++kept;
    }
  }
  triangles.Points.resize(kept);
  triangles.Outgoing.resize(kept);
  mesh.PointOfVertex.resize(kept);
  for (auto& triangle : triangles.Triangles)
  {
    for (int& corner : triangle)
    {
      corner = newVertex[corner];
    }
  }
}

/// The triangles of a cell follow one another.
int CountTurnedFaces(const MendedMesh& mesh, const std::vector<char>& isTurned)
{
  int count = 0;
  int last = -1;
  for (std::size_t t = 0; t < isTurned.size(); ++t)
  {
    if (isTurned[t] && mesh.CellOfTriangle[t] != last)
    {
      last = mesh.CellOfTriangle[t];
      ++count;
    }
  }
  return count;
}

/// The cells that have no triangle, and not because another has it.
int CountFacesWithoutArea(const PolygonMesh& input, const Mending& mending)
{
  std::vector<char> has(input.NumberOfPolygons(), 0);
  for (int cell : mending.Result.CellOfTriangle)
  {
    if (cell >= 0)
    {
      has[cell] = 1;
    }
  }
  int count = 0;
  for (int c = 0; c < input.NumberOfPolygons(); ++c)
  {
    count += !has[c] && mending.TwinOfCell[c] < 0 ? 1 : 0;
  }
  return count;
}
}

void MendSurface(const PolygonMesh& input, Mending& mending, SurfaceReport& report)
{
  MendedMesh& mesh = mending.Result;
  mending.TwinOfCell.assign(input.NumberOfPolygons(), -1);
  report.CutPolygons = TriangulatePolygons(input, mesh);
  report.MergedPoints = WeldPoints(mesh, mending.Representative);
  RemoveCollapsedTriangles(mesh);
  report.FacesTwice = RemoveTwinTriangles(mesh, mending.TwinOfCell);
  report.SplitEdges = PairSheets(mesh.Mesh);
  const OrientationChanges changes = OrientTriangles(mesh.Mesh);
  report.TurnedFaces = CountTurnedFaces(mesh, changes.IsTurned);
  report.CutEdges = changes.CutEdges;
  report.SplitPoints = SeparateFans(mesh);
  report.FilledHoles = FillHoles(mesh);
  const int flipped = RemoveFlatTriangles(mesh);
  RemoveUnusedVertices(mesh);
  report.FacesWithoutArea = flipped + CountFacesWithoutArea(input, mending);
}
}
