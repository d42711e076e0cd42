// SPDX-License-Identifier: BSD-3-Clause
#include "FaceLabels.h"

#include "LabelCut.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// What a boundary of the length of the diagonal weighs against the whole area; anything from 0.3 to
/// 0.8 does.
constexpr double BoundaryWeight = 0.4;
/// Smaller shares are what smoothing leaves far away, and no evidence.
constexpr double LeastShare = 1e-3;
/// A segment's core: where its share is the largest of all and nearly what it is at most.
constexpr double CoreShare = 0.99;
}

double ShareOfTriangle(
  const TriangleMesh& mesh, const Eigen::MatrixXd& shares, int triangle, int segment)
{
  const auto& [a, b, c] = mesh.Triangles[triangle];
  return (shares(a, segment) + shares(b, segment) + shares(c, segment)) / 3.0;
}

std::vector<int> LabelFaces(const TriangleMesh& mesh, const Eigen::MatrixXd& shares,
  const std::vector<double>& prices, const std::vector<std::vector<int>>& excluded,
  const Progress& progress)
{
  const int numberOfSegments = static_cast<int>(shares.cols());
  std::vector<double> most(numberOfSegments, 0.0);
  double totalArea = 0.0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    totalArea += mesh.Area(t);
    for (int segment = 0; segment < numberOfSegments; ++segment)
    {
      most[segment] = std::max(most[segment], ShareOfTriangle(mesh, shares, t, segment));
    }
  }

  LabelProblem problem;
  problem.NumberOfLabels = numberOfSegments;
  problem.Costs.resize(mesh.NumberOfTriangles());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    auto& costs = problem.Costs[t];
    const double weight = totalArea > 0.0 ? mesh.Area(t) / totalArea : 0.0;
    int likeliest = 0;
    double largest = -1.0;
    const auto consider = [&](int segment)
    {
      const double share = ShareOfTriangle(mesh, shares, t, segment);
      if (share > largest)
      {
        largest = share;
        likeliest = segment;
      }
      if (share > LeastShare)
      {
        costs.emplace_back(segment, -weight * std::log(share));
      }
    };
    for (int segment = 0; segment < numberOfSegments; ++segment)
    {
      if (excluded.empty() ||
        std::find(excluded[t].begin(), excluded[t].end(), segment) == excluded[t].end())
      {
        consider(segment);
      }
    }
    const bool isAnyAllowed = largest >= 0.0;
    if (!isAnyAllowed)
    {
      for (int segment = 0; segment < numberOfSegments; ++segment)
      {
        consider(segment);
      }
    }
    if (costs.empty() || largest >= CoreShare * most[likeliest])
    {
      costs.assign(1, { likeliest, 0.0 });
    }
  }

  for (int h = 0; h < static_cast<int>(prices.size()); ++h)
  {
    if (mesh.Opposite[h] <= h)
    {
      continue;
    }
    const int a = TriangleMesh::TriangleOf(h);
    const int b = TriangleMesh::TriangleOf(mesh.Opposite[h]);
    if (problem.Costs[a].size() > 1 || problem.Costs[b].size() > 1)
    {
      problem.Edges.push_back({ a, b, BoundaryWeight * prices[h] });
    }
  }
  return SolveLabels(problem, progress);
}
}
