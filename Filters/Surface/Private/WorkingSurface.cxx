// SPDX-License-Identifier: BSD-3-Clause
#include "WorkingSurface.h"

#include "BinaryScale.h"
#include "BodyAssembly.h"
#include "InputCheck.h"
#include "MeshCheck.h"
#include "NearestTriangles.h"
#include "Simplification.h"
#include "SurfaceMending.h"
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

namespace marrow
{
namespace
{
int NearestCorner(const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& point)
{
  const auto& c = mesh.Triangles[triangle];
  return *std::min_element(c.begin(), c.end(),
    [&](int a, int b)
    { return (mesh.Points[a] - point).squaredNorm() < (mesh.Points[b] - point).squaredNorm(); });
}

/// Full triangles to cells.
void MapCells(const PolygonMesh& input, const Mending& mending, WorkingSurface& output)
{
  output.FullTriangleOfCell.assign(input.NumberOfPolygons(), -1);
  for (int t = output.Full.NumberOfTriangles(); t-- > 0;)
  {
    if (output.CellOfFullTriangle[t] >= 0)
    {
      output.FullTriangleOfCell[output.CellOfFullTriangle[t]] = t;
    }
  }
  std::optional<TriangleTree> tree;
  for (int c = 0; c < input.NumberOfPolygons(); ++c)
  {
    int& triangle = output.FullTriangleOfCell[c];
    // Polygons of several triangles may be each other's twins, and both be without area.
    std::set<int> seen;
    for (int twin = mending.TwinOfCell[c]; triangle < 0 && twin >= 0 && seen.insert(twin).second;
         twin = mending.TwinOfCell[twin])
    {
      triangle = output.FullTriangleOfCell[twin];
    }
    if (triangle >= 0)
    {
      continue;
    }
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int k = 0; k < input.SizeOf(c); ++k)
    {
      middle += input.Points[input.CornersOf(c)[k]] / input.SizeOf(c);
    }
    if (!tree)
    {
      tree.emplace(output.Full);
    }
    triangle = tree->Nearest(middle).Triangle;
  }
}

/// Working vertices and points to one another, by the full vertices between them.
void MapPoints(const PolygonMesh& input, const Mending& mending,
  const std::vector<int>& vertexOfFull, WorkingSurface& output)
{
  std::vector<int> fullOfPoint(input.Points.size(), -1);
  for (int v = output.Full.NumberOfVertices(); v-- > 0;)
  {
    fullOfPoint[output.PointOfFullVertex[v]] = v;
  }
  const std::vector<char> used = UsedPoints(input);
  output.VertexOfPoint.assign(input.Points.size(), -1);
  std::optional<TriangleTree> tree;
  for (int p = 0; p < input.NumberOfPoints(); ++p)
  {
    if (!used[p])
    {
      continue;
    }
    const int full = fullOfPoint[mending.Representative[p]];
    if (full >= 0)
    {
      output.VertexOfPoint[p] = vertexOfFull[full];
      continue;
    }
    if (!tree)
    {
      tree.emplace(output.Mesh);
    }
    output.VertexOfPoint[p] =
      NearestCorner(output.Mesh, tree->Nearest(input.Points[p]).Triangle, input.Points[p]);
  }
}

void FindBodies(WorkingSurface& output)
{
  output.BodyOfTriangle = TriangleComponents(output.Mesh, output.NumberOfBodies);
  std::vector<double> area(output.NumberOfBodies, 0.0);
  for (int t = 0; t < output.Mesh.NumberOfTriangles(); ++t)
  {
    area[output.BodyOfTriangle[t]] += output.Mesh.Area(t);
  }
  std::vector<int> order(output.NumberOfBodies);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return area[a] > area[b]; });
  std::vector<int> rank(output.NumberOfBodies);
  for (int i = 0; i < output.NumberOfBodies; ++i)
  {
    rank[order[i]] = i;
  }
  for (int& body : output.BodyOfTriangle)
  {
    body = rank[body];
  }
}

template <typename Map>
std::vector<int> Composed(const std::vector<int>& first, const Map& second)
{
  std::vector<int> result(first.size());
  std::transform(first.begin(), first.end(), result.begin(), [&](int i) { return second[i]; });
  return result;
}
}

std::string ComputeWorkingSurface(const PolygonMesh& input,
  const WorkingSurfaceParameters& parameters, const Progress& progress, WorkingSurface& output)
{
  output = {};
  std::string error = CheckInput(input);
  if (!error.empty())
  {
    return error;
  }
  const int exponent = ScaleExponent(input.Points, input.Corners);
  PolygonMesh scaled;
  if (exponent != 0)
  {
    scaled = input;
    Scale(scaled.Points, -exponent);
  }
  const PolygonMesh& source = exponent != 0 ? scaled : input;

  const std::vector<char> used = UsedPoints(input);
  output.Report.UnusedPoints = static_cast<int>(std::count(used.begin(), used.end(), 0));
  Mending mending;
  MendSurface(source, mending, output.Report);
  if (mending.Result.Mesh.Triangles.empty())
  {
    return "None of the mesh's faces has an area: connect a surface.";
  }
  output.Full = std::move(mending.Result.Mesh);
  output.CellOfFullTriangle = std::move(mending.Result.CellOfTriangle);
  output.PointOfFullVertex = std::move(mending.Result.PointOfVertex);
  MapCells(source, mending, output);
  if (!Report(progress, 0.3))
  {
    return {};
  }

  BodyAssembly bodies;
  if (!AssembleBodies(output.Full, parameters.MaximumFaces, SubProgress(progress, 0.3, 0.6), bodies,
        output.Report))
  {
    return {};
  }
  std::vector<int> vertexOfFull(output.Full.Points.size());
  std::vector<int> fullOfVertex;
  if (bodies.IsWhole)
  {
    std::iota(vertexOfFull.begin(), vertexOfFull.end(), 0);
    fullOfVertex = vertexOfFull;
    output.TriangleOfFullTriangle.resize(output.Full.Triangles.size());
    std::iota(output.TriangleOfFullTriangle.begin(), output.TriangleOfFullTriangle.end(), 0);
    output.Mesh = output.Full;
  }
  else
  {
    output.Mesh = std::move(bodies.Mesh);
    vertexOfFull = std::move(bodies.VertexOfFull);
    fullOfVertex = std::move(bodies.FullOfVertex);
    output.TriangleOfFullTriangle = std::move(bodies.TriangleOfFull);
  }
  const int mostFaces = bodies.IsWhole ? parameters.MaximumFaces : bodies.MostFaces;
  if (output.Mesh.NumberOfTriangles() > mostFaces)
  {
    SimplifiedMesh simplified;
    if (!SimplifyMesh(output.Mesh, mostFaces, SubProgress(progress, 0.6, 1.0), simplified))
    {
      return {};
    }
    if (simplified.Mesh.NumberOfTriangles() < output.Mesh.NumberOfTriangles())
    {
      FindNearest(output.Mesh, simplified);
      output.Report.SimplifiedTriangles = output.Mesh.NumberOfTriangles();
      output.TriangleOfFullTriangle =
        Composed(output.TriangleOfFullTriangle, simplified.TriangleOfOld);
      vertexOfFull = Composed(vertexOfFull, simplified.VertexOfOld);
      fullOfVertex = Composed(simplified.OldVertex, fullOfVertex);
      output.Mesh = std::move(simplified.Mesh);
    }
  }
  MapPoints(source, mending, vertexOfFull, output);
  output.PointOfVertex = Composed(fullOfVertex, output.PointOfFullVertex);
  FindBodies(output);
  output.IsInput = output.Report.IsEmpty();
  Scale(output.Full.Points, exponent);
  Scale(output.Mesh.Points, exponent);
  Report(progress, 1.0);
  return {};
}
}
