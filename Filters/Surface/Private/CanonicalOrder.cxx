// SPDX-License-Identifier: BSD-3-Clause
#include "CanonicalOrder.h"

#include "BinaryScale.h"
#include "CanonicalFrame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

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

std::vector<int> Numbers(std::size_t size)
{
  std::vector<int> numbers(size);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}
}

CanonicalPolygons InCanonicalOrder(const PolygonMesh& input)
{
  const std::vector<Place> places = PlacesOfPoints(input);
  CanonicalPolygons result;
  result.OriginalPoint = Numbers(input.Points.size());
  std::sort(result.OriginalPoint.begin(), result.OriginalPoint.end(),
    [&](int a, int b) { return std::tie(places[a], a) < std::tie(places[b], b); });
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
  { return input.CornersOf(polygon)[(begin[polygon] + k) % input.SizeOf(polygon)]; };
  result.OriginalPolygon = Numbers(begin.size());
  std::sort(result.OriginalPolygon.begin(), result.OriginalPolygon.end(),
    [&](int a, int b)
    {
      const int common = std::min(input.SizeOf(a), input.SizeOf(b));
      for (int k = 0; k < common; ++k)
      {
        const int ofA = rankOfPlace[corner(a, k)];
        const int ofB = rankOfPlace[corner(b, k)];
        if (ofA != ofB)
        {
          return ofA < ofB;
        }
      }
      return std::pair(input.SizeOf(a), a) < std::pair(input.SizeOf(b), b);
    });
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
