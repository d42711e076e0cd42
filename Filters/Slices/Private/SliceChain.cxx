// SPDX-License-Identifier: BSD-3-Clause
#include "SliceChain.h"

#include "Constants.h"
#include "WeightedMedian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace marrow
{
namespace
{
/// So that a foot or a lip has some.
constexpr int NumberOfSlices = 100;
/// Radii that differ by less are one; handmade and scanned vases keep to it.
constexpr double RadiusTolerance = 0.05;
/// What is farther out than the wall by this factor is a handle or a spout.
constexpr double AppendedFactor = 1.25;

/// A piece of the line along which the plane of a slice cuts a triangle.
struct Cut
{
  double Radius = 0.0;
  double Angle = 0.0; ///< as seen from the axis; positive where the surface faces outward
  double Slope = 0.0; ///< the component of the triangle's normal along the axis
};

/// From −π to π, counterclockwise.
double AngleBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// `corners` are seen from the axis: x and y across, z along it. Long cuts are several, so that the side
/// of a box is not taken for an arc.
void AddCuts(const std::array<Eigen::Vector3d, 3>& corners, double height, double slope,
  std::vector<Cut>& cuts)
{
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d& a = corners[k];
    const Eigen::Vector3d& b = corners[(k + 1) % 3];
    const bool isUp = a.z() >= height;
    if (isUp != (b.z() >= height))
    {
      const double t = (height - a.z()) / (b.z() - a.z());
      (isUp ? from : to) = ((1.0 - t) * a + t * b).head<2>();
    }
  }
  // With the triangles oriented outward, the part of a plane below goes round to the left.
  constexpr double mostAngle = Pi / 30.0; // over which radii differ by less than a percent
  const int pieces = 1 + static_cast<int>(std::abs(AngleBetween(from, to)) / mostAngle);
  Eigen::Vector2d begin = from;
  for (int piece = 1; piece <= pieces; ++piece)
  {
    const Eigen::Vector2d end = from + (to - from) * piece / pieces;
    cuts.push_back({ (0.5 * (begin + end)).norm(), AngleBetween(begin, end), slope });
    begin = end;
  }
}

SliceChain::Slice SliceOf(const std::vector<Cut>& cuts)
{
  std::vector<std::pair<double, double>> radii;
  for (const Cut& cut : cuts)
  {
    if (cut.Angle > 0.0)
    {
      radii.emplace_back(cut.Radius, cut.Angle);
    }
  }
  SliceChain::Slice slice;
  slice.Radius = WeightedMedian(std::move(radii));
  double total = 0.0;
  double round = 0.0;
  for (const Cut& cut : cuts)
  {
    if (cut.Angle > 0.0 && cut.Radius < AppendedFactor * slice.Radius)
    {
      slice.Slope += cut.Angle * cut.Slope;
      total += cut.Angle;
      const double difference = std::abs(cut.Radius - slice.Radius);
      round += difference < RadiusTolerance * slice.Radius ? cut.Angle : 0.0;
    }
  }
  slice.Slope = total > 0.0 ? slice.Slope / total : 0.0;
  slice.Roundness = std::min(1.0, round / (2.0 * Pi));
  return slice;
}

/// `points` are the mesh's vertices as seen from the axis.
std::vector<SliceChain::Slice> SlicesOf(const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& axis, double low, double high)
{
  const double thickness = (high - low) / NumberOfSlices;
  std::vector<std::vector<Cut>> cuts(NumberOfSlices);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto& [a, b, c] = mesh.Triangles[t];
    const std::array<Eigen::Vector3d, 3> corners{ points[a], points[b], points[c] };
    const double slope = mesh.AreaVector(t).stableNormalized().dot(axis);
    const auto [least, most] = std::minmax({ points[a].z(), points[b].z(), points[c].z() });
    const double first = std::max(std::floor((least - low) / thickness), 0.0);
    for (int s = static_cast<int>(std::min<double>(first, NumberOfSlices)); s < NumberOfSlices; ++s)
    {
      const double height = low + (s + 0.5) * thickness;
      if (height > most)
      {
        break;
      }
      if (height > least)
      {
        AddCuts(corners, height, slope, cuts[s]);
      }
    }
  }
  std::vector<SliceChain::Slice> slices;
  for (const std::vector<Cut>& ofSlice : cuts)
  {
    slices.push_back(SliceOf(ofSlice));
  }
  return slices;
}

/// Where there is no outer wall, in an open mesh, the profile goes on as beside it.
void FillGaps(std::vector<SliceChain::Slice>& slices)
{
  const auto fill = [](SliceChain::Slice& slice, const SliceChain::Slice& beside)
  {
    if (!(slice.Radius > 0.0))
    {
      slice = beside;
    }
  };
  for (std::size_t s = 1; s < slices.size(); ++s)
  {
    fill(slices[s], slices[s - 1]);
  }
  for (std::size_t s = slices.size() - 1; s > 0; --s)
  {
    fill(slices[s - 1], slices[s]);
  }
}
}

SliceChain::SliceChain(const TriangleMesh& mesh, const RevolutionAxis& axis)
{
  const Eigen::Vector3d across = axis.Direction.unitOrthogonal();
  this->Frame << across, axis.Direction.cross(across), axis.Direction;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& point : mesh.Points)
  {
    points.push_back(this->Frame.transpose() * (point - axis.Point));
    low = std::min(low, points.back().z());
    high = std::max(high, points.back().z());
  }
  this->Slices.assign(NumberOfSlices, {});
  if (!(high > low))
  {
    return;
  }
  this->Slices = SlicesOf(mesh, points, axis.Direction, low, high);
  for (const Slice& slice : this->Slices)
  {
    this->Roundness += slice.Roundness / NumberOfSlices;
  }
  // A spout or a handle that reaches beyond the wall does not lengthen it.
  constexpr double ofWall = 0.5; // of the directions
  const auto isWall = [](const Slice& slice) { return slice.Roundness > ofWall; };
  const auto first = std::find_if(this->Slices.begin(), this->Slices.end(), isWall);
  const auto last = std::find_if(this->Slices.rbegin(), this->Slices.rend(), isWall);
  if (first != this->Slices.end())
  {
    const double thickness = (high - low) / NumberOfSlices;
    high -= thickness * static_cast<double>(last - this->Slices.rbegin());
    low += thickness * static_cast<double>(first - this->Slices.begin());
    this->Slices = SlicesOf(mesh, points, axis.Direction, low, high);
  }
  FillGaps(this->Slices);
  this->Thickness = (high - low) / NumberOfSlices;
  this->Start = axis.Point + low * axis.Direction;
}

bool SliceChain::IsOfRevolution() const
{
  // Of vases with handles and spouts two thirds go round, of a bust half, of a table a third.
  constexpr double least = 0.6;
  return this->Roundness > least;
}

bool SliceChain::IsAppended(const Eigen::Vector3d& point) const
{
  const double place = this->PlaceOf(point);
  if (place < -1.0 || place > NumberOfSlices + 1.0)
  {
    return true;
  }
  // Between two slices the wall may step out.
  const int slice = std::clamp(static_cast<int>(place), 0, NumberOfSlices - 1);
  double radius = 0.0;
  for (int s = std::max(slice - 1, 0); s <= std::min(slice + 1, NumberOfSlices - 1); ++s)
  {
    radius = std::max(radius, this->Slices[s].Radius);
  }
  return this->OffsetOf(point).norm() > AppendedFactor * radius;
}

std::shared_ptr<const SliceChain> FindSlices(const TriangleMesh& mesh)
{
  auto slices = std::make_shared<const SliceChain>(mesh, FindRevolutionAxis(mesh));
  return slices->IsOfRevolution() ? slices : nullptr;
}

double SliceChain::TypicalRadius() const
{
  // Flanges take up less than a tenth of a shaft, its thickest part more than a fifth: 0.8 to 0.9 does.
  constexpr double shareOfSlices = 0.85;
  std::vector<double> radii;
  for (const Slice& slice : this->Slices)
  {
    radii.push_back(slice.Radius);
  }
  const auto typical = radii.begin() + static_cast<int>(shareOfSlices * NumberOfSlices);
  std::nth_element(radii.begin(), typical, radii.end());
  return *typical;
}

double SliceChain::PlaceOf(const Eigen::Vector3d& point) const
{
  return this->Frame.col(2).dot(point - this->Start) / this->Thickness;
}

double SliceChain::RadiusAt(double place) const
{
  const double shifted = std::clamp(place - 0.5, 0.0, NumberOfSlices - 1.0);
  const int below = std::min(static_cast<int>(shifted), NumberOfSlices - 2);
  const double t = shifted - below;
  return (1.0 - t) * this->Slices[below].Radius + t * this->Slices[below + 1].Radius;
}

Eigen::Vector3d SliceChain::PointAt(double place, const Eigen::Vector3d& offset) const
{
  return this->Start + place * this->Thickness * this->Frame.col(2) + offset;
}

Eigen::Vector3d SliceChain::OffsetOf(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d fromStart = point - this->Start;
  return fromStart - this->Frame.col(2).dot(fromStart) * this->Frame.col(2);
}
}
