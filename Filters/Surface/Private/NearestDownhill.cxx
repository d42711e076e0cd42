// SPDX-License-Identifier: BSD-3-Clause
#include "NearestDownhill.h"

#include "TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marrow
{
NearestDownhill::NearestDownhill(const TriangleMesh& mesh)
  : Mesh(mesh)
{
  this->Balls.reserve(mesh.Triangles.size());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Eigen::Vector3d centroid = mesh.Centroid(t);
    double squared = 0.0;
    for (const int corner : mesh.Triangles[t])
    {
      squared = std::max(squared, (mesh.Points[corner] - centroid).squaredNorm());
    }
    this->Balls.push_back({ centroid, std::sqrt(squared) });
  }
}

int NearestDownhill::Find(const Eigen::Vector3d& point, int start) const
{
  int best = start;
  double least = this->SquaredDistance(point, start);
  double leastDistance = std::sqrt(least);
  const auto offer = [&](int t)
  {
    if (this->IsBeyond(point, t, leastDistance))
    {
      return;
    }
    const double distance = this->SquaredDistance(point, t);
    if (distance < least)
    {
      least = distance;
      leastDistance = std::sqrt(least);
      best = t;
    }
  };
  // Over edges as long as that helps, as few are looked at, and then over corners.
  for (int last = -1; last != best;)
  {
    std::array<int, 4> seen{};
    for (int step = -1; step != best;)
    {
      step = best;
      seen.fill(step);
      for (int k = 0; k < 3; ++k)
      {
        const int opposite = this->Mesh.Opposite[3 * step + k];
        if (opposite >= 0)
        {
          seen[k] = TriangleMesh::TriangleOf(opposite);
          offer(seen[k]);
        }
      }
    }
    last = best;
    for (const int corner : this->Mesh.Triangles[last])
    {
      this->Mesh.ForEachOutgoing(corner,
        [&](int h)
        {
          const int t = TriangleMesh::TriangleOf(h);
          if (std::find(seen.begin(), seen.end(), t) == seen.end())
          {
            offer(t);
          }
        });
    }
  }
  return best;
}

bool NearestDownhill::IsBeyond(const Eigen::Vector3d& point, int triangle, double distance) const
{
  const Ball& ball = this->Balls[triangle];
  constexpr double withRounding = 1.0 + 1e-6; // more than rounding can take away
  const double reach = (ball.Radius + distance) * withRounding;
  return (point - ball.Center).squaredNorm() > reach * reach;
}

double NearestDownhill::SquaredDistance(const Eigen::Vector3d& point, int triangle) const
{
  const auto& [a, b, c] = this->Mesh.Triangles[triangle];
  const auto& points = this->Mesh.Points;
  return (point - NearestOnTriangle(point, points[a], points[b], points[c])).squaredNorm();
}
}
