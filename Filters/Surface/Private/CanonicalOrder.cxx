// SPDX-License-Identifier: BSD-3-Clause
#include "CanonicalOrder.h"

#include "BinaryScale.h"
#include "CanonicalFrame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace marrow
{
namespace
{
using Place = std::array<double, 3>;

std::vector<Place> PlacesOfPoints(const PolygonMesh& mesh)
{
  const int exponent = -ScaleExponent(mesh.Points, mesh.Corners);
  std::vector<Eigen::Vector3d> points = mesh.Points;
  Scale(points, exponent);
  std::vector<Eigen::Vector3d> centers;
  std::vector<double> areas;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const int size = mesh.SizeOf(polygon);
    const Eigen::Vector3d& first = points[mesh.CornersOf(polygon)[0]];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (int k = 0; k < size; ++k)
    {
      const Eigen::Vector3d point = points[mesh.CornersOf(polygon)[k]] - first;
      const Eigen::Vector3d next = points[mesh.CornersOf(polygon)[(k + 1) % size]] - first;
      sum += point;
      area += point.cross(next);
    }
    centers.emplace_back(first + sum / std::max(size, 1));
    areas.push_back(area.norm());
  }
  const CanonicalFrame frame(centers, areas);
  std::vector<Place> places(points.size(), Place{});
  // Of points that no polygon uses the coordinates may be anything.
  for (int corner : mesh.Corners)
  {
    const Eigen::Vector3d place = frame.ToFrame(points[corner]);
    places[corner] = { place.x(), place.y(), place.z() };
  }
  return places;
}

std::vector<int> PointsByPlace(const std::vector<Place>& places)
{
  // The first coordinate beside the number: it decides nearly always.
  std::vector<std::pair<double, int>> order;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    order.emplace_back(places[i][0], static_cast<int>(i));
  }
  std::sort(order.begin(), order.end(),
    [&](const auto& a, const auto& b)
    {
      return a.first != b.first
        ? a.first < b.first
        : std::tie(places[a.second], a.second) < std::tie(places[b.second], b.second);
    });
  std::vector<int> points;
  for (const auto& entry : order)
  {
    points.push_back(entry.second);
  }
  return points;
}

/// corner(polygon, k) are a polygon's points from that of least rank on.
template <typename Corner>
std::vector<int> PolygonsByCorners(
  const PolygonMesh& mesh, const std::vector<int>& rankOfPlace, const Corner& corner)
{
  // The rank of the first corner beside the number: few polygons share it.
  std::vector<std::pair<int, int>> order;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    order.emplace_back(mesh.SizeOf(polygon) > 0 ? rankOfPlace[corner(polygon, 0)] : -1, polygon);
  }
  std::sort(order.begin(), order.end(),
    [&](const std::pair<int, int>& x, const std::pair<int, int>& y)
    {
      if (x.first != y.first)
      {
        return x.first < y.first;
      }
      const int a = x.second;
      const int b = y.second;
      const int common = std::min(mesh.SizeOf(a), mesh.SizeOf(b));
      for (int k = 0; k < common; ++k)
      {
        const int ofA = rankOfPlace[corner(a, k)];
        const int ofB = rankOfPlace[corner(b, k)];
        if (ofA != ofB)
        {
          return ofA < ofB;
        }
      }
      return std::pair(mesh.SizeOf(a), a) < std::pair(mesh.SizeOf(b), b);
    });
  std::vector<int> polygons;
  for (const auto& entry : order)
  {
    polygons.push_back(entry.second);
  }
  return polygons;
}
}

CanonicalPolygons InCanonicalOrder(const PolygonMesh& input)
{
  const std::vector<Place> places = PlacesOfPoints(input);
  CanonicalPolygons result;
  result.OriginalPoint = PointsByPlace(places);
  std::vector<int> rank(input.Points.size());
  // Points in one place share a rank in the order of the polygons: which of them a polygon uses is chance.
  std::vector<int> rankOfPlace(input.Points.size());
  for (std::size_t i = 0; i < rank.size(); ++i)
  {
    const int point = result.OriginalPoint[i];
    rank[point] = static_cast<int>(i);
    const bool isSame = i > 0 && places[result.OriginalPoint[i - 1]] == places[point];
    rankOfPlace[point] = isSame ? rankOfPlace[result.OriginalPoint[i - 1]] : static_cast<int>(i);
    result.Mesh.Points.push_back(input.Points[point]);
  }

  // Each polygon begins at its corner of least rank.
  std::vector<int> begin(input.NumberOfPolygons(), 0);
  for (int polygon = 0; polygon < input.NumberOfPolygons(); ++polygon)
  {
    for (int k = 1; k < input.SizeOf(polygon); ++k)
    {
      if (rankOfPlace[input.CornersOf(polygon)[k]] <
        rankOfPlace[input.CornersOf(polygon)[begin[polygon]]])
      {
        begin[polygon] = k;
      }
    }
  }
  const auto corner = [&](int polygon, int k)
  {
    const int size = input.SizeOf(polygon);
    const int place = begin[polygon] + k;
    return input.CornersOf(polygon)[place < size ? place : place - size];
  };
  result.OriginalPolygon = PolygonsByCorners(input, rankOfPlace, corner);
  for (int polygon : result.OriginalPolygon)
  {
    for (int k = 0; k < input.SizeOf(polygon); ++k)
    {
      result.Mesh.Corners.push_back(rank[corner(polygon, k)]);
    }
    result.Mesh.Offsets.push_back(static_cast<int>(result.Mesh.Corners.size()));
  }
  return result;
}
}
