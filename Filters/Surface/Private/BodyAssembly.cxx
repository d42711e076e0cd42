// SPDX-License-Identifier: BSD-3-Clause
#include "BodyAssembly.h"

#include "MeshCheck.h"
#include "PartRelations.h"
#include "TriangleTree.h"
#include "VolumeWrap.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace marrow
{
namespace
{
/// The fewest triangles of the working surface with which a body has a skeleton: eight nodes, each of a
/// ring of eight vertices, two triangles to a vertex.
constexpr double LeastBodyFaces = 8 * 8 * 2;

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

  void TakeTriangle(int t)
  {
    TriangleMesh& mesh = this->Assembly.Mesh;
    this->Assembly.TriangleOfFull[t] = mesh.NumberOfTriangles();
    mesh.Triangles.push_back(this->Full.Triangles[t]);
    for (int& corner : mesh.Triangles.back())
    {
      int& vertex = this->Assembly.VertexOfFull[corner];
      if (vertex < 0)
      {
        vertex = mesh.NumberOfVertices();
        mesh.Points.push_back(this->Full.Points[corner]);
        this->Assembly.FullOfVertex.push_back(corner);
      }
      corner = vertex;
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
}

bool AssembleBodies(const TriangleMesh& full, int maximumFaces, const Progress& progress,
  BodyAssembly& assembly, SurfaceReport& report)
{
  double area = 0.0;
  for (int t = 0; t < full.NumberOfTriangles(); ++t)
  {
    area += full.Area(t);
  }
  // A net has two triangles for each square of its grid, and half as many again as the surface lies
  // aslant: twice as many as are wanted.
  const double spacing = std::sqrt(1.5 * area / maximumFaces);
  const double leastShare = std::min(1.0, LeastBodyFaces / maximumFaces);
  PartRelations relations;
  if (!RelateParts(full, leastShare, 0.5 * spacing, SubProgress(progress, 0.0, 0.5), relations))
  {
    return false;
  }
  std::map<int, std::vector<int>> groups; // the parts of each body
  for (int part = 0; part < relations.NumberOfParts; ++part)
  {
    if (relations.IsShreds)
    {
      groups[0].push_back(part);
    }
    else if (!relations.IsLeftOut[part])
    {
      groups[relations.Group[part]].push_back(part);
    }
  }
  report.LeftOutParts =
    static_cast<int>(std::count(relations.IsLeftOut.begin(), relations.IsLeftOut.end(), 1));
  std::vector<char> isWrapped(relations.NumberOfParts, 0);
  for (const auto& [first, parts] : groups)
  {
    if (relations.IsShreds)
    {
      report.WrappedShreds = static_cast<int>(parts.size());
    }
    else if (parts.size() > 1)
    {
      report.UnitedParts += static_cast<int>(parts.size());
    }
    for (int part : parts)
    {
      isWrapped[part] = relations.IsShreds || parts.size() > 1;
    }
  }
  assembly.IsWhole =
    report.LeftOutParts == 0 && std::count(isWrapped.begin(), isWrapped.end(), 1) == 0;
  if (assembly.IsWhole)
  {
    return true;
  }

  Assembler assembler(full, assembly);
  std::map<int, std::vector<int>> wrapped; // triangles, per group
  for (int t = 0; t < full.NumberOfTriangles(); ++t)
  {
    const int part = relations.PartOfTriangle[t];
    if (isWrapped[part])
    {
      wrapped[relations.IsShreds ? 0 : relations.Group[part]].push_back(t);
    }
    else if (!relations.IsLeftOut[part])
    {
      assembler.TakeTriangle(t);
    }
  }
  for (const auto& [group, triangles] : wrapped)
  {
    assembler.TakeWrap(WrapVolume(full, triangles, spacing), triangles, leastShare * area);
    if (!Report(progress, 0.75))
    {
      return false;
    }
  }
  assembler.MapTheRest();
  return Report(progress, 1.0);
}
}
