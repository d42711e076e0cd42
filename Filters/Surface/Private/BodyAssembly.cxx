// SPDX-License-Identifier: BSD-3-Clause
#include "BodyAssembly.h"

#include "MeshCheck.h"
#include "PartRelations.h"
#include "TriangleTree.h"
#include "VolumeWrap.h"
#include "WorkingSurface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace marrow
{
namespace
{
/// The fewest triangles of the working surface with which a body has a skeleton: eight nodes, each of a
/// ring of eight vertices, two triangles to a vertex.
constexpr double LeastBodyFaces = 8 * 8 * 2;

/// A working surface may be asked to stay as large as its mesh, without bound. What is drawn anew is no
/// finer than the one of the default size, on which the method is at its best.
const int MostFacesDrawn = WorkingSurfaceParameters().MaximumFaces;

/// And no coarser than gives each of a hundred places along the limbs of a body a ring of fifty vertices.
constexpr int LeastFacesDrawn = 2 * 100 * 50;

int NearestCorner(const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& point)
{
  const auto& c = mesh.Triangles[triangle];
  return *std::min_element(c.begin(), c.end(),
    [&](int a, int b)
    { return (mesh.Points[a] - point).squaredNorm() < (mesh.Points[b] - point).squaredNorm(); });
}

/// A wrap breaks what it cannot show into crumbs of its own.
std::vector<char> LargeComponents(const TriangleMesh& wrap, double leastArea)
{
  int count = 0;
  const std::vector<int> component = TriangleComponents(wrap, count);
  std::vector<double> area(count, 0.0);
  for (int t = 0; t < wrap.NumberOfTriangles(); ++t)
  {
    area[component[t]] += wrap.Area(t);
  }
  const double largest = count > 0 ? *std::max_element(area.begin(), area.end()) : 0.0;
  std::vector<char> keep(wrap.Triangles.size());
  for (int t = 0; t < wrap.NumberOfTriangles(); ++t)
  {
    keep[t] = area[component[t]] >= std::min(leastArea, largest) ? 1 : 0;
  }
  return keep;
}

class Assembler
{
public:
  Assembler(const TriangleMesh& full, BodyAssembly& assembly)
    : Full(full)
    , Assembly(assembly)
  {
    assembly.TriangleOfFull.assign(full.Triangles.size(), -1);
    assembly.VertexOfFull.assign(full.Points.size(), -1);
  }

  /// Some triangles as they are, with their vertices, all in the order that they have.
  void Take(const std::vector<int>& triangles)
  {
    TriangleMesh& mesh = this->Assembly.Mesh;
    std::vector<int>& newVertex = this->Assembly.VertexOfFull;
    for (int t : triangles)
    {
      for (int corner : this->Full.Triangles[t])
      {
        newVertex[corner] = 0;
      }
    }
    for (int v = 0; v < this->Full.NumberOfVertices(); ++v)
    {
      if (newVertex[v] == 0)
      {
        newVertex[v] = mesh.NumberOfVertices();
        mesh.Points.push_back(this->Full.Points[v]);
        this->Assembly.FullOfVertex.push_back(v);
      }
    }
    for (int t : triangles)
    {
      this->Assembly.TriangleOfFull[t] = mesh.NumberOfTriangles();
      const auto& c = this->Full.Triangles[t];
      mesh.Triangles.push_back({ newVertex[c[0]], newVertex[c[1]], newVertex[c[2]] });
    }
  }

  void TakeWrap(const TriangleMesh& wrap, const std::vector<int>& wrapped, double leastArea)
  {
    TriangleMesh& mesh = this->Assembly.Mesh;
    const TriangleTree tree(this->Full, wrapped);
    const std::vector<char> keep = LargeComponents(wrap, leastArea);
    std::vector<int> newVertex(wrap.Points.size(), -1);
    for (int t = 0; t < wrap.NumberOfTriangles(); ++t)
    {
      if (!keep[t])
      {
        continue;
      }
      mesh.Triangles.push_back(wrap.Triangles[t]);
      for (int& corner : mesh.Triangles.back())
      {
        if (newVertex[corner] < 0)
        {
          const Eigen::Vector3d& point = wrap.Points[corner];
          newVertex[corner] = mesh.NumberOfVertices();
          mesh.Points.push_back(point);
          this->Assembly.FullOfVertex.push_back(
            NearestCorner(this->Full, tree.Nearest(point).Triangle, point));
        }
        corner = newVertex[corner];
      }
    }
  }

  /// Whatever was not taken as it is gets the nearest of what was made.
  void MapTheRest()
  {
    TriangleMesh& mesh = this->Assembly.Mesh;
    mesh.BuildConnectivity();
    const TriangleTree tree(mesh);
    for (int t = 0; t < this->Full.NumberOfTriangles(); ++t)
    {
      int& triangle = this->Assembly.TriangleOfFull[t];
      triangle = triangle < 0 ? tree.Nearest(this->Full.Centroid(t)).Triangle : triangle;
    }
    for (int v = 0; v < this->Full.NumberOfVertices(); ++v)
    {
      int& vertex = this->Assembly.VertexOfFull[v];
      const Eigen::Vector3d& point = this->Full.Points[v];
      vertex = vertex < 0 ? NearestCorner(mesh, tree.Nearest(point).Triangle, point) : vertex;
    }
  }

private:
  const TriangleMesh& Full;
  BodyAssembly& Assembly;
};
/// What becomes of the triangles of a mesh.
struct Plan
{
  std::vector<int> Taken;                  ///< as they are
  std::map<int, std::vector<int>> Wrapped; ///< per body
  std::map<int, int> NumberOfWrappedParts; ///< likewise
};

Plan PlanBodies(const PartRelations& relations)
{
  Plan plan;
  auto bodyOf = [&](int part) { return relations.IsShreds ? 0 : relations.Group[part]; };
  std::map<int, int> numberOfParts;
  for (int part = 0; part < relations.NumberOfParts; ++part)
  {
    numberOfParts[bodyOf(part)] += relations.IsLeftOut[part] ? 0 : 1;
  }
  for (std::size_t t = 0; t < relations.PartOfTriangle.size(); ++t)
  {
    const int part = relations.PartOfTriangle[t];
    if (relations.IsLeftOut[part])
    {
      continue;
    }
    const int body = bodyOf(part);
    if (relations.IsShreds || numberOfParts[body] > 1)
    {
      plan.Wrapped[body].push_back(static_cast<int>(t));
      plan.NumberOfWrappedParts[body] = numberOfParts[body];
    }
    else
    {
      plan.Taken.push_back(static_cast<int>(t));
    }
  }
  return plan;
}
}

bool AssembleBodies(const TriangleMesh& full, int maximumFaces, const Progress& progress,
  BodyAssembly& assembly, SurfaceReport& report)
{
  const int faces = std::min(maximumFaces, MostFacesDrawn);
  double area = 0.0;
  for (int t = 0; t < full.NumberOfTriangles(); ++t)
  {
    area += full.Area(t);
  }
  // A net has two triangles for each square of its grid, and half as many again as the surface lies
  // aslant: twice as many as are wanted.
  const auto spacingFor = [area](int wanted) { return std::sqrt(1.5 * area / wanted); };
  const double spacing = spacingFor(faces);
  const double leastShare = std::min(1.0, LeastBodyFaces / faces);
  PartRelations relations;
  if (!RelateParts(full, leastShare, spacing, SubProgress(progress, 0.0, 0.5), relations))
  {
    return false;
  }
  report.LeftOutParts =
    static_cast<int>(std::count(relations.IsLeftOut.begin(), relations.IsLeftOut.end(), 1));
  Plan plan = PlanBodies(relations);
  // The squares of a net are all of one size, where a mesh is finer in some places than in others.
  const int drawn = std::min(std::max(2 * full.NumberOfTriangles(), LeastFacesDrawn), faces);
  std::vector<std::pair<TriangleMesh, const std::vector<int>*>> wraps;
  for (const auto& [body, triangles] : plan.Wrapped)
  {
    if (!Report(progress, 0.5 + 0.4 * wraps.size() / plan.Wrapped.size()))
    {
      return false;
    }
    TriangleMesh wrap = WrapVolume(full, triangles, spacingFor(drawn), drawn);
    if (wrap.Triangles.empty())
    {
      // Too small for the grid beside what lies far away.
      plan.Taken.insert(plan.Taken.end(), triangles.begin(), triangles.end());
      continue;
    }
    wraps.emplace_back(std::move(wrap), &triangles);
    (relations.IsShreds ? report.WrappedShreds : report.UnitedParts) +=
      plan.NumberOfWrappedParts[body];
  }
  assembly.IsWhole = report.LeftOutParts == 0 && wraps.empty();
  if (assembly.IsWhole)
  {
    return true;
  }
  assembly.MostFaces =
    std::min(maximumFaces, static_cast<int>(plan.Taken.size()) + (wraps.empty() ? 0 : drawn));
  std::sort(plan.Taken.begin(), plan.Taken.end());
  Assembler assembler(full, assembly);
  assembler.Take(plan.Taken);
  for (const auto& [wrap, triangles] : wraps)
  {
    assembler.TakeWrap(wrap, *triangles, leastShare * area);
  }
  assembler.MapTheRest();
  return Report(progress, 1.0);
}
}
