// SPDX-License-Identifier: BSD-3-Clause
#include "EnclosedBranch.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// The share of a junction's vertices on one side of a loop from which on the loop cuts it.
constexpr double Cut = 0.1;
/// A branch may leave the loop's plane a little outside of its circle, as loops are not round.
constexpr double JustOutside = 1.2;

/// Per node the share of its vertices to the left of the loop. Nodes without vertices take the mean
/// of their neighbours.
std::vector<double> ShareOfNodes(
  const AnalyzedMesh& side, const std::vector<int>& halfEdges, const std::vector<char>& sides)
{
  const TriangleMesh& mesh = side.Mesh;
  std::vector<double> vertexSide(mesh.NumberOfVertices(), 0.0);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    for (int corner : mesh.Triangles[t])
    {
      vertexSide[corner] = std::max(vertexSide[corner], static_cast<double>(sides[t]));
    }
  }
  for (int h : halfEdges)
  {
    vertexSide[mesh.From(h)] = 0.5;
  }
  const int numberOfNodes = side.Skeleton.NumberOfNodes();
  std::vector<double> share(numberOfNodes, 0.0);
  std::vector<int> count(numberOfNodes, 0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const int node = side.NodeOfVertex[v];
    if (node >= 0)
    {
      share[node] += vertexSide[v];
      ++count[node];
    }
  }
  for (int n = 0; n < numberOfNodes; ++n)
  {
    share[n] = count[n] > 0 ? share[n] / count[n] : -1.0;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    std::vector<double> filled = share;
    for (int n = 0; n < numberOfNodes; ++n)
    {
      if (share[n] >= 0.0)
      {
        continue;
      }
      double sum = 0.0;
      int known = 0;
      for (auto [e, end] = boost::out_edges(n, side.Skeleton.Graph); e != end; ++e)
      {
        const double value = share[boost::target(*e, side.Skeleton.Graph)];
        if (value >= 0.0)
        {
          sum += value;
          ++known;
        }
      }
      if (known > 0)
      {
        filled[n] = sum / known;
        changed = true;
      }
    }
    share = filled;
  }
  return share;
}

bool IsLeft(double share)
{
  return share > 0.5;
}

/// The places (node index and fraction, as arc length) where a branch changes sides.
std::vector<double> CrossingsOfBranch(const Branch& branch, const std::vector<double>& share)
{
  std::vector<double> crossings;
  for (std::size_t i = 1; i < branch.Nodes.size(); ++i)
  {
    const double a = share[branch.Nodes[i - 1]];
    const double b = share[branch.Nodes[i]];
    if (IsLeft(a) != IsLeft(b))
    {
      const double fraction = std::clamp((0.5 - a) / (b - a), 0.0, 1.0);
      crossings.push_back(
        branch.ArcLength[i - 1] + fraction * (branch.ArcLength[i] - branch.ArcLength[i - 1]));
    }
  }
  return crossings;
}

int NumberOfCutBranches(const Skeleton& skeleton, const std::vector<double>& share)
{
  return static_cast<int>(std::count_if(skeleton.Branches.begin(), skeleton.Branches.end(),
    [&](const Branch& branch) { return CrossingsOfBranch(branch, share).size() % 2 == 1; }));
}

/// Puts each junction that the loop cuts through on the side that leaves fewer branches cut.
void SettleJunctions(const Skeleton& skeleton, std::vector<double>& share)
{
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    if (skeleton.TypeOf(n) != NodeType::Junction || share[n] < Cut || share[n] > 1.0 - Cut)
    {
      continue;
    }
    const int before = NumberOfCutBranches(skeleton, share);
    std::vector<double> flipped = share;
    flipped[n] = 1.0 - share[n];
    const int after = NumberOfCutBranches(skeleton, flipped);
    if (after > 0 && (before == 0 || after < before))
    {
      share = flipped;
    }
  }
}

/// Where the branch crosses the plane inside the loop, nearest to `near`; `near` itself if nowhere
/// within `reach` along the branch.
double CrossingOfPlane(const Skeleton& skeleton, const Branch& branch, const FittingPlane& plane,
  double near, double reach, bool& found)
{
  double best = near;
  double bestDistance = reach;
  found = false;
  for (std::size_t i = 1; i < branch.Nodes.size(); ++i)
  {
    const Eigen::Vector3d& p = skeleton.Graph[branch.Nodes[i - 1]].Position;
    const Eigen::Vector3d& q = skeleton.Graph[branch.Nodes[i]].Position;
    const double a = plane.Offset(p);
    const double b = plane.Offset(q);
    if ((a < 0.0) == (b < 0.0))
    {
      continue;
    }
    const double fraction = a / (a - b);
    const Eigen::Vector3d point = p + fraction * (q - p);
    const double arc =
      branch.ArcLength[i - 1] + fraction * (branch.ArcLength[i] - branch.ArcLength[i - 1]);
    if ((point - plane.Center).norm() < JustOutside * plane.Radius &&
      std::abs(arc - near) <= bestDistance)
    {
      bestDistance = std::abs(arc - near);
      best = arc;
      found = true;
    }
  }
  return best;
}
}

bool SidesOfLoop(
  const TriangleMesh& mesh, const std::vector<int>& halfEdges, std::vector<char>& sides)
{
  std::vector<bool> isCut(mesh.Opposite.size(), false);
  for (int h : halfEdges)
  {
    isCut[h] = true;
    isCut[mesh.Opposite[h]] = true;
  }
  sides.assign(mesh.NumberOfTriangles(), 0);
  std::vector<int> stack;
  for (int h : halfEdges)
  {
    const int triangle = TriangleMesh::TriangleOf(h);
    if (!sides[triangle])
    {
      sides[triangle] = 1;
      stack.push_back(triangle);
    }
  }
  while (!stack.empty())
  {
    const int triangle = stack.back();
    stack.pop_back();
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
    {
      const int opposite = mesh.Opposite[h];
      if (opposite >= 0 && !isCut[h] && !sides[TriangleMesh::TriangleOf(opposite)])
      {
        sides[TriangleMesh::TriangleOf(opposite)] = 1;
        stack.push_back(TriangleMesh::TriangleOf(opposite));
      }
    }
  }
  return std::none_of(halfEdges.begin(), halfEdges.end(),
    [&](int h) { return sides[TriangleMesh::TriangleOf(mesh.Opposite[h])] != 0; });
}

FittingPlane FitPlane(const TriangleMesh& mesh, const std::vector<int>& loopVertices)
{
  FittingPlane plane;
  const std::size_t n = loopVertices.size();
  double length = 0.0;
  std::vector<double> weights(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = (i + 1) % n;
    const double edge = (mesh.Points[loopVertices[next]] - mesh.Points[loopVertices[i]]).norm();
    weights[i] += 0.5 * edge;
    weights[next] += 0.5 * edge;
    length += edge;
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    plane.Center += weights[i] * mesh.Points[loopVertices[i]];
  }
  plane.Center /= std::max(length, 1e-300);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Eigen::Vector3d d = mesh.Points[loopVertices[i]] - plane.Center;
    covariance += weights[i] * d * d.transpose();
    plane.Radius += weights[i] * d.norm();
  }
  plane.Radius /= std::max(length, 1e-300);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  plane.Normal = solver.eigenvectors().col(0);
  return plane;
}

Enclosure FindEnclosure(const AnalyzedMesh& side, const std::vector<int>& halfEdges)
{
  Enclosure result;
  std::vector<int> vertices;
  for (int h : halfEdges)
  {
    vertices.push_back(side.Mesh.From(h));
  }
  const FittingPlane plane = FitPlane(side.Mesh, vertices);
  const Skeleton& skeleton = side.Skeleton;
  std::vector<char> sides;
  if (!SidesOfLoop(side.Mesh, halfEdges, sides))
  {
    for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
    {
      bool found = false;
      const double length = skeleton.Branches[b].Length();
      const double arc =
        CrossingOfPlane(skeleton, skeleton.Branches[b], plane, 0.5 * length, length, found);
      if (found)
      {
        ++result.NumberOfBranches;
        result.Branch = b;
        result.ArcLength = arc;
      }
    }
    if (result.NumberOfBranches != 1)
    {
      result.Branch = -1;
    }
    return result;
  }

  std::vector<double> share = ShareOfNodes(side, halfEdges, sides);
  SettleJunctions(skeleton, share);
  for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
  {
    const std::vector<double> crossings = CrossingsOfBranch(skeleton.Branches[b], share);
    if (crossings.size() % 2 == 1)
    {
      ++result.NumberOfBranches;
      result.Branch = b;
      result.ArcLength = crossings[crossings.size() / 2];
    }
  }
  if (result.NumberOfBranches != 1)
  {
    result.Branch = -1;
    return result;
  }
  bool found = false;
  result.ArcLength = CrossingOfPlane(
    skeleton, skeleton.Branches[result.Branch], plane, result.ArcLength, plane.Radius, found);
  return result;
}
}
