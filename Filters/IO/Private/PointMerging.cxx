// SPDX-License-Identifier: BSD-3-Clause
#include "PointMerging.h"

#include <functional>
#include <unordered_map>

namespace marrow
{
namespace
{
struct HashOfPoint
{
  std::size_t operator()(const Eigen::Vector3d& point) const
  {
    // std::hash gives 0 and -0, which are equal, the same value. The factor spreads the bits.
    constexpr std::size_t Factor = 0x9E3779B97F4A7C15U;
    std::size_t hash = 0;
    for (const double coordinate : point)
    {
      hash = (hash ^ std::hash<double>()(coordinate)) * Factor;
      hash ^= hash >> 32;
    }
    return hash;
  }
};
}

void MergeEqualPoints(FileMesh& mesh)
{
  std::unordered_map<Eigen::Vector3d, int, HashOfPoint> first;
  first.reserve(mesh.Points.size() / 4);
  std::vector<int> newIndex(mesh.Points.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const Eigen::Vector3d point = mesh.Points[i];
    const int next = static_cast<int>(kept);
    newIndex[i] = point.allFinite() ? first.emplace(point, next).first->second : next;
    if (newIndex[i] == next)
    {
      mesh.Points[kept++] = point;
    }
  }
  mesh.Points.resize(kept);
  for (int& corner : mesh.Corners)
  {
    corner = newIndex[corner];
  }
}
}
