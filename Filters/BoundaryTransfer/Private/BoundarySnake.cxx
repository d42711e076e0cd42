// SPDX-License-Identifier: BSD-3-Clause
#include "BoundarySnake.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// Places that a point may move to in one step; work grows with the square.
constexpr std::size_t MostCandidates = 9;

struct Snaxel
{
  double V = 0.0;
  Eigen::Vector3d Point = Eigen::Vector3d::Zero();
  double Distance = 0.0; ///< from where the curve was
  double Energy = 0.0;
};

/// Where the line of constant u crosses edges of the region: the nearest of them.
std::vector<Snaxel> FindSnaxels(const TriangleMesh& mesh, const CylinderMap& map, double u,
  const Eigen::Vector3d& at, double radius)
{
  std::vector<Snaxel> snaxels;
  const std::vector<int>& triangles = map.GetRegion().Triangles;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto& uv = map.Corners(i);
    const auto& corners = mesh.Triangles[triangles[i]];
    for (int k = 0; k < 3; ++k)
    {
      // Every inner edge is seen from both sides; one is enough.
      const int h = 3 * triangles[i] + k;
      const int next = (k + 1) % 3;
      if (mesh.Opposite[h] > h)
      {
        continue;
      }
      const double middle = 0.5 * (uv[k].x() + uv[next].x());
      const double line = u + std::round(middle - u);
      const double span = uv[next].x() - uv[k].x();
      const double t = span != 0.0 ? (line - uv[k].x()) / span : -1.0;
      if (t < 0.0 || t > 1.0)
      {
        continue;
      }
      Snaxel snaxel;
      snaxel.V = (1.0 - t) * uv[k].y() + t * uv[next].y();
      snaxel.Point = (1.0 - t) * mesh.Points[corners[k]] + t * mesh.Points[corners[next]];
      snaxel.Distance = (snaxel.Point - at).norm();
      snaxels.push_back(snaxel);
    }
  }
  std::sort(snaxels.begin(), snaxels.end(),
    [](const Snaxel& a, const Snaxel& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.V < b.V; });
  std::size_t count = 0;
  while (count < snaxels.size() && count < MostCandidates &&
    (count == 0 || snaxels[count].Distance <= radius))
  {
    ++count;
  }
  snaxels.resize(count);
  return snaxels;
}
}

void RefineCurve(const AnalyzedMesh& target, const CylinderMap& map, const SnakeGoal& goal,
  TransferredCurve& curve)
{
  const TriangleMesh& mesh = target.Mesh;
  const std::size_t n = curve.Points.size();
  const double diagonal = target.Diagonal();
  std::vector<bool> isSeen(mesh.NumberOfVertices(), false);
  std::vector<int> vertices;
  for (int t : map.GetRegion().Triangles)
  {
    for (int corner : mesh.Triangles[t])
    {
      if (!isSeen[corner])
      {
        isSeen[corner] = true;
        vertices.push_back(corner);
      }
    }
  }

  std::vector<std::vector<Snaxel>> snaxels(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    snaxels[i] = FindSnaxels(mesh, map, curve.Uv[i].x(), curve.Points[i], goal.SearchRadius);
    if (snaxels[i].empty())
    {
      return;
    }
    std::vector<int> features;
    for (int v : vertices)
    {
      if ((mesh.Points[v] - curve.Points[i]).norm() <= goal.SearchRadius &&
        std::abs(target.DihedralAngle[v] - goal.DihedralAngles[i]) < goal.DihedralTolerance)
      {
        features.push_back(v);
      }
    }
    for (Snaxel& snaxel : snaxels[i])
    {
      double feature = features.empty() ? 0.0 : Infinity;
      for (int v : features)
      {
        feature = std::min(feature, (mesh.Points[v] - snaxel.Point).norm());
      }
      const double shape = std::abs(goal.Offsets[i] - goal.Plane.Offset(snaxel.Point));
      snaxel.Energy = (feature + shape) / diagonal;
    }
  }

  // A displacement along v is a length of v times the height of the annulus.
  const auto& rims = map.GetRegion().Rims;
  const auto meanOffset = [&](const std::vector<int>& rim)
  {
    double sum = 0.0;
    for (int v : rim)
    {
      sum += goal.Plane.Offset(mesh.Points[v]);
    }
    return sum / rim.size();
  };
  const double stiffness = std::abs(meanOffset(rims[1]) - meanOffset(rims[0])) / diagonal;
  const auto bend = [&](std::size_t i, const Snaxel& a, std::size_t j, const Snaxel& b)
  { return stiffness * std::abs((a.V - curve.Uv[i].y()) - (b.V - curve.Uv[j].y())); };

  double least = Infinity;
  std::vector<std::size_t> best;
  for (std::size_t start = 0; start < snaxels[0].size(); ++start)
  {
    std::vector<std::vector<std::size_t>> from(n);
    std::vector<double> reached(snaxels[0].size(), Infinity);
    reached[start] = snaxels[0][start].Energy;
    for (std::size_t i = 1; i < n; ++i)
    {
      std::vector<double> next(snaxels[i].size(), Infinity);
      from[i].assign(snaxels[i].size(), 0);
      for (std::size_t b = 0; b < snaxels[i].size(); ++b)
      {
        for (std::size_t a = 0; a < snaxels[i - 1].size(); ++a)
        {
          const double energy = reached[a] + bend(i - 1, snaxels[i - 1][a], i, snaxels[i][b]);
          if (energy < next[b])
          {
            next[b] = energy;
            from[i][b] = a;
          }
        }
        next[b] += snaxels[i][b].Energy;
      }
      reached = std::move(next);
    }
    for (std::size_t last = 0; last < reached.size(); ++last)
    {
      const double energy = reached[last] + bend(n - 1, snaxels[n - 1][last], 0, snaxels[0][start]);
      if (energy < least)
      {
        least = energy;
        best.assign(n, last);
        for (std::size_t i = n - 1; i > 0; --i)
        {
          best[i - 1] = from[i][best[i]];
        }
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const Snaxel& snaxel = snaxels[i][best[i]];
    curve.Uv[i].y() = snaxel.V;
    curve.Points[i] = snaxel.Point;
  }
}
}
