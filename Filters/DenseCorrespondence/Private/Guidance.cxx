// SPDX-License-Identifier: BSD-3-Clause
#include "Guidance.h"

#include "HintCost.h"

#include <algorithm>
#include <utility>

namespace marrow
{
namespace
{
bool HasNode(const Branch& branch, int node)
{
  return std::find(branch.Nodes.begin(), branch.Nodes.end(), node) != branch.Nodes.end();
}
}

std::vector<NodeHint> ToNodeHints(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const std::vector<SurfaceHint>& hints)
{
  std::vector<NodeHint> result;
  for (const SurfaceHint& hint : hints)
  {
    const int s = source.NodeOfVertex[hint.SourceVertex];
    const int t = target.NodeOfVertex[hint.TargetVertex];
    if (s >= 0 && t >= 0)
    {
      result.push_back({ s, t, hint.IsForbidden });
    }
  }
  return result;
}

std::vector<SurfaceHint> Turned(const std::vector<SurfaceHint>& hints)
{
  std::vector<SurfaceHint> turned = hints;
  for (SurfaceHint& hint : turned)
  {
    std::swap(hint.SourceVertex, hint.TargetVertex);
  }
  return turned;
}

double DistanceToTriangle(const AnalyzedMesh& mesh, int vertex, int triangle)
{
  return (mesh.Mesh.Centroid(triangle) - mesh.Mesh.Points[vertex]).norm() /
    std::max(mesh.Diagonal(), 1e-300);
}

bool AreOfSamePart(const AnalyzedMesh& mesh, int vertex, int triangle)
{
  // Points of two fingers side by side are further apart than that.
  constexpr double near = 0.05;
  const int node = mesh.NodeOfVertex[vertex];
  const int other = mesh.NodeOfVertex[mesh.Mesh.Triangles[triangle][0]];
  return DistanceToTriangle(mesh, vertex, triangle) < near ||
    std::any_of(mesh.Skeleton.Branches.begin(), mesh.Skeleton.Branches.end(),
      [&](const Branch& branch) { return HasNode(branch, node) && HasNode(branch, other); });
}

double CostOfHints(const AnalyzedMesh& source, const std::vector<SurfaceHint>& hints,
  const std::vector<int>& foundTriangles)
{
  double cost = 0.0;
  for (const SurfaceHint& hint : hints)
  {
    const int found = foundTriangles[hint.TargetVertex];
    if (hint.IsForbidden)
    {
      cost += AreOfSamePart(source, hint.SourceVertex, found) ? HintCost::Weight : 0.0;
    }
    else
    {
      // Squared, as proportions differ: small distances say little.
      const double distance = DistanceToTriangle(source, hint.SourceVertex, found);
      cost += HintCost::Weight * distance * distance;
    }
  }
  return cost;
}

int NumberOfUnmetHints(const AnalyzedMesh& source, const std::vector<SurfaceHint>& hints,
  const std::vector<int>& foundTriangles)
{
  return static_cast<int>(std::count_if(hints.begin(), hints.end(),
    [&](const SurfaceHint& hint)
    {
      return AreOfSamePart(source, hint.SourceVertex, foundTriangles[hint.TargetVertex]) ==
        hint.IsForbidden;
    }));
}
}
