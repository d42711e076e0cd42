// SPDX-License-Identifier: BSD-3-Clause
#include "FullResolution.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace marrow
{
namespace
{
using Shares = std::map<int, double>;

int LargestShare(const Shares& shares)
{
  return std::max_element(
    shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
    ->first;
}

std::vector<Shares> SharesOfVertices(
  const TriangleMesh& mesh, const std::vector<int>& labelOfTriangle)
{
  std::vector<Shares> shares(mesh.Points.size());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const double area = mesh.Area(t);
    for (int corner : mesh.Triangles[t])
    {
      shares[corner][labelOfTriangle[t]] += area;
    }
  }
  for (Shares& ofVertex : shares)
  {
    double total = 0.0;
    for (const auto& [label, area] : ofVertex)
    {
      total += area;
    }
    for (auto& [label, area] : ofVertex)
    {
      area = total > 0.0 ? area / total : 1.0;
    }
  }
  return shares;
}

/// Barycentric coordinates of the point of the triangle's plane below `point`, clamped to the triangle.
Eigen::Vector3d CoordinatesBelow(
  const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& point)
{
  const auto& corners = mesh.Triangles[triangle];
  const Eigen::Vector3d normal = mesh.AreaVector(triangle);
  const double square = normal.squaredNorm();
  if (!(square > 0.0))
  {
    return Eigen::Vector3d::Constant(1.0 / 3.0);
  }
  Eigen::Vector3d coordinates;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d a = mesh.Points[corners[(k + 1) % 3]] - point;
    const Eigen::Vector3d b = mesh.Points[corners[(k + 2) % 3]] - point;
    coordinates[k] = std::max(0.0, a.cross(b).dot(normal) / square);
  }
  return coordinates / coordinates.sum();
}
}

std::vector<int> LabelsAtFullResolution(
  const WorkingSurface& surface, const std::vector<int>& labelOfTriangle)
{
  const bool isSame = surface.Full.Triangles.size() == surface.Mesh.Triangles.size();
  std::vector<Shares> shares;
  if (!isSame)
  {
    shares = SharesOfVertices(surface.Mesh, labelOfTriangle);
  }
  std::vector<int> labels(surface.Full.Triangles.size());
  for (int t = 0; t < surface.Full.NumberOfTriangles(); ++t)
  {
    const int nearest = surface.TriangleOfFullTriangle[t];
    labels[t] = labelOfTriangle[nearest];
    if (isSame)
    {
      continue;
    }
    const auto& corners = surface.Mesh.Triangles[nearest];
    const bool isInside = std::all_of(
      corners.begin(), corners.end(), [&](int corner) { return shares[corner].size() == 1; });
    if (!isInside)
    {
      const Eigen::Vector3d coordinates =
        CoordinatesBelow(surface.Mesh, nearest, surface.Full.Centroid(t));
      Shares here;
      for (int k = 0; k < 3; ++k)
      {
        for (const auto& [label, share] : shares[corners[k]])
        {
          here[label] += coordinates[k] * share;
        }
      }
      labels[t] = LargestShare(here);
    }
  }
  return labels;
}

std::vector<int> LabelsOfPolygons(
  const WorkingSurface& surface, const std::vector<int>& labelOfFullTriangle)
{
  const std::size_t numberOfPolygons = surface.FullTriangleOfCell.size();
  std::vector<int> labels(numberOfPolygons);
  for (std::size_t c = 0; c < numberOfPolygons; ++c)
  {
    labels[c] = labelOfFullTriangle[surface.FullTriangleOfCell[c]];
  }
  // Polygons of several triangles whose labels differ.
  std::map<int, Shares> mixed;
  for (std::size_t t = 0; t < labelOfFullTriangle.size(); ++t)
  {
    const int polygon = surface.CellOfFullTriangle[t];
    if (polygon >= 0 && labelOfFullTriangle[t] != labels[polygon])
    {
      mixed[polygon];
    }
  }
  if (!mixed.empty())
  {
    for (std::size_t t = 0; t < labelOfFullTriangle.size(); ++t)
    {
      const auto found = mixed.find(surface.CellOfFullTriangle[t]);
      if (found != mixed.end())
      {
        found->second[labelOfFullTriangle[t]] += surface.Full.Area(static_cast<int>(t));
      }
    }
    for (const auto& [polygon, shares] : mixed)
    {
      labels[polygon] = LargestShare(shares);
    }
  }
  return labels;
}
}
