// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCheck.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace marrow
{
namespace
{
std::string Sentence(const Defect& defect, const std::string& one, const std::string& many,
  const std::string& firstKind, const std::string& remedy)
{
  const bool single = defect.Count == 1;
  return "The mesh has " + std::to_string(defect.Count) + " " + (single ? one : many) + " (" +
    (single ? "" : "the first ") + "at " + firstKind + " " + std::to_string(defect.First) +
    "): " + remedy + ".";
}
}

int MeshReport::Genus() const
{
  // Every border closed by a disc, every component has χ = 2 - 2 genus.
  const int closed = this->EulerCharacteristic + this->NumberOfBorders;
  return this->NumberOfComponents - closed / 2;
}

std::string MeshReport::ManifoldError() const
{
  if (this->InvalidPoints.Count > 0)
  {
    return Sentence(this->InvalidPoints, "point whose coordinates are not finite",
      "points whose coordinates are not finite", "point", "remove or repair them");
  }
  if (this->DegenerateTriangles.Count > 0)
  {
    return Sentence(this->DegenerateTriangles, "triangle that uses a point twice",
      "triangles that use a point twice", "cell", "run vtkCleanPolyData first");
  }
  if (this->NonManifoldEdges.Count > 0)
  {
    return Sentence(this->NonManifoldEdges, "edge with more than two triangles",
      "edges with more than two triangles", "point",
      "separate the sheets or remove the extra triangles");
  }
  if (this->InconsistentEdges.Count > 0)
  {
    return Sentence(this->InconsistentEdges,
      "edge whose two triangles are oriented against each other",
      "edges whose two triangles are oriented against each other", "point",
      "run vtkPolyDataNormals with ConsistencyOn and SplittingOff first");
  }
  if (this->NonManifoldVertices.Count > 0)
  {
    return Sentence(this->NonManifoldVertices, "vertex where separate fans of triangles touch",
      "vertices where separate fans of triangles touch", "point", "give each fan its own vertex");
  }
  return {};
}

std::string MeshReport::ClosedError() const
{
  return this->IsClosed() ? std::string()
                          : Sentence(this->BorderEdges, "border edge", "border edges", "point",
                              "close its holes first, for example with vtkFillHolesFilter");
}

std::vector<int> TriangleComponents(const TriangleMesh& mesh, int& numberOfComponents)
{
  std::vector<int> component(mesh.Triangles.size(), -1);
  std::vector<int> stack;
  numberOfComponents = 0;
  for (int seed = 0; seed < mesh.NumberOfTriangles(); ++seed)
  {
    if (component[seed] >= 0)
    {
      continue;
    }
    component[seed] = numberOfComponents;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const int t = stack.back();
      stack.pop_back();
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        const int opposite = mesh.Opposite[h];
        if (opposite >= 0 && component[TriangleMesh::TriangleOf(opposite)] < 0)
        {
          component[TriangleMesh::TriangleOf(opposite)] = numberOfComponents;
          stack.push_back(TriangleMesh::TriangleOf(opposite));
        }
      }
    }
    ++numberOfComponents;
  }
  return component;
}

MeshReport CheckMesh(const TriangleMesh& mesh)
{
  MeshReport report;
  const int numberOfHalfEdges = 3 * mesh.NumberOfTriangles();
  std::vector<int> cornersOfVertex(mesh.Points.size(), 0);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto& c = mesh.Triangles[t];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
    {
      report.DegenerateTriangles.Add(t);
    }
    for (int corner : c)
    {
      ++cornersOfVertex[corner];
    }
  }

  int usedPoints = 0;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (!mesh.Points[v].allFinite())
    {
      report.InvalidPoints.Add(v);
    }
    if (cornersOfVertex[v] == 0)
    {
      report.UnusedPoints.Add(v);
      continue;
    }
    ++usedPoints;
  }

  // A half-edge without an opposite is a border, or an edge that is not manifold: the number of
  // half-edges that share its ends, and their directions, tell.
  std::vector<std::pair<std::pair<int, int>, bool>> unmatched;
  int matchedHalfEdges = 0;
  for (int h = 0; h < numberOfHalfEdges; ++h)
  {
    if (mesh.Opposite[h] >= 0)
    {
      ++matchedHalfEdges;
      continue;
    }
    const int from = mesh.From(h);
    const int to = mesh.To(h);
    unmatched.push_back({ { std::min(from, to), std::max(from, to) }, from < to });
  }
  std::sort(unmatched.begin(), unmatched.end());
  int unmatchedEdges = 0;
  for (std::size_t first = 0; first < unmatched.size();)
  {
    std::size_t last = first + 1;
    while (last < unmatched.size() && unmatched[last].first == unmatched[first].first)
    {
      ++last;
    }
    const int id = unmatched[first].first.first;
    if (last - first == 1)
    {
      report.BorderEdges.Add(id);
    }
    else if (last - first == 2)
    {
      report.InconsistentEdges.Add(id);
    }
    else
    {
      report.NonManifoldEdges.Add(id);
    }
    ++unmatchedEdges;
    first = last;
  }

  const bool edgesAreManifold = report.DegenerateTriangles.Count == 0 &&
    report.NonManifoldEdges.Count == 0 && report.InconsistentEdges.Count == 0;
  if (edgesAreManifold)
  {
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      int fan = 0;
      mesh.ForEachOutgoing(v, [&](int) { ++fan; });
      if (fan != cornersOfVertex[v])
      {
        report.NonManifoldVertices.Add(v);
      }
    }
    std::vector<char> seen(numberOfHalfEdges, 0);
    for (int h = 0; h < numberOfHalfEdges && report.NonManifoldVertices.Count == 0; ++h)
    {
      if (mesh.Opposite[h] >= 0 || seen[h])
      {
        continue;
      }
      ++report.NumberOfBorders;
      for (int walk = h; !seen[walk];)
      {
        seen[walk] = 1;
        // The border goes on with the half-edge that starts the fan of the end vertex.
        walk = mesh.Outgoing[mesh.To(walk)];
      }
    }
  }

  report.EulerCharacteristic =
    usedPoints - (matchedHalfEdges / 2 + unmatchedEdges) + mesh.NumberOfTriangles();
  TriangleComponents(mesh, report.NumberOfComponents);
  return report;
}
}
