// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace marrow
{
void TriangleMesh::BuildConnectivity()
{
  const int numberOfHalfEdges = 3 * this->NumberOfTriangles();
  // The half-edges by the lower of their ends: few share one.
  std::vector<int> first(this->Points.size() + 1, 0);
  const auto low = [this](int h) { return std::min(this->From(h), this->To(h)); };
  for (int h = 0; h < numberOfHalfEdges; ++h)
  {
    ++first[low(h)];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> halfEdges(numberOfHalfEdges);
  for (int h = numberOfHalfEdges; h-- > 0;)
  {
    halfEdges[--first[low(h)]] = h;
  }

  this->Opposite.assign(numberOfHalfEdges, -1);
  std::vector<std::pair<int, int>> group; // the higher end beside the half-edge
  for (std::size_t v = 0; v < this->Points.size(); ++v)
  {
    group.clear();
    for (int i = first[v]; i < first[v + 1]; ++i)
    {
      const int h = halfEdges[i];
      group.emplace_back(std::max(this->From(h), this->To(h)), h);
    }
    std::sort(group.begin(), group.end());
    for (std::size_t begin = 0; begin < group.size();)
    {
      std::size_t end = begin + 1;
      while (end < group.size() && group[end].first == group[begin].first)
      {
        ++end;
      }
      if (end == begin + 2)
      {
        const int a = group[begin].second;
        const int b = group[begin + 1].second;
        if (this->From(a) == this->To(b) && this->From(a) != this->To(a))
        {
          this->Opposite[a] = b;
          this->Opposite[b] = a;
        }
      }
      begin = end;
    }
  }

  this->Outgoing.assign(this->Points.size(), -1);
  for (int h = 0; h < numberOfHalfEdges; ++h)
  {
    const int vertex = this->From(h);
    // A half-edge without an opposite starts the fan of a border vertex.
    if (this->Outgoing[vertex] < 0 || this->Opposite[h] < 0)
    {
      this->Outgoing[vertex] = h;
    }
  }
}

Eigen::Vector3d TriangleMesh::AreaVector(int triangle) const
{
  const auto& corners = this->Triangles[triangle];
  const Eigen::Vector3d& a = this->Points[corners[0]];
  return (this->Points[corners[1]] - a).cross(this->Points[corners[2]] - a);
}

Eigen::Vector3d TriangleMesh::Centroid(int triangle) const
{
  const auto& corners = this->Triangles[triangle];
  return (this->Points[corners[0]] + this->Points[corners[1]] + this->Points[corners[2]]) / 3.0;
}

std::vector<double> TriangleMesh::TriangleAreas() const
{
  std::vector<double> areas(this->Triangles.size());
  for (int t = 0; t < this->NumberOfTriangles(); ++t)
  {
    areas[t] = this->Area(t);
  }
  return areas;
}

std::vector<double> TriangleMesh::VertexAreas() const
{
  std::vector<double> areas(this->Points.size(), 0.0);
  for (int t = 0; t < this->NumberOfTriangles(); ++t)
  {
    const double third = this->Area(t) / 3.0;
    for (int corner : this->Triangles[t])
    {
      areas[corner] += third;
    }
  }
  return areas;
}

std::vector<Eigen::Vector3d> TriangleMesh::VertexNormals() const
{
  std::vector<Eigen::Vector3d> normals(this->Points.size(), Eigen::Vector3d::Zero());
  for (int t = 0; t < this->NumberOfTriangles(); ++t)
  {
    const Eigen::Vector3d areaVector = this->AreaVector(t);
    const double length = areaVector.norm();
    if (length <= 0.0)
    {
      continue;
    }
    const auto& corners = this->Triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d a = this->Points[corners[(k + 1) % 3]] - this->Points[corners[k]];
      const Eigen::Vector3d b = this->Points[corners[(k + 2) % 3]] - this->Points[corners[k]];
      const double angle = std::atan2(length, a.dot(b));
      normals[corners[k]] += (angle / length) * areaVector;
    }
  }
  for (auto& normal : normals)
  {
    const double length = normal.norm();
    if (length > 0.0)
    {
      normal /= length;
    }
  }
  return normals;
}

double TriangleMesh::BoundingBoxDiagonal() const
{
  if (this->Points.empty())
  {
    return 0.0;
  }
  Eigen::Vector3d low = this->Points.front();
  Eigen::Vector3d high = low;
  for (const auto& point : this->Points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).norm();
}
}
