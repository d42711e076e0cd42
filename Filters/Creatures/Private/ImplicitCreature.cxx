// SPDX-License-Identifier: BSD-3-Clause
#include "ImplicitCreature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
/// Position and radius in one, so that both get the same interpolation.
Eigen::Vector4d Control(const Joint& joint)
{
  return { joint.Position.x(), joint.Position.y(), joint.Position.z(), joint.Radius };
}

/// Where the round cone between two balls is nearest to a point. A round cone is the hull of its
/// balls; the ball that touches the hull nearest to the point lies off the foot of the
/// perpendicular by the slope of the cone.
double RoundConeParameter(double along, double aside, double length, double radiusA, double radiusB)
{
  const double slope = (radiusA - radiusB) / length;
  if (slope >= 1.0)
  {
    return 0.0;
  }
  if (slope <= -1.0)
  {
    return length;
  }
  return std::clamp(along - aside * slope / std::sqrt(1.0 - slope * slope), 0.0, length);
}
}

CenterLine SampleCenterLine(const Limb& limb)
{
  CenterLine line;
  auto add = [&line](const Eigen::Vector3d& position, double radius)
  {
    const double step = line.Positions.empty() ? 0.0 : (position - line.Positions.back()).norm();
    line.ArcLength.push_back(line.ArcLength.empty() ? 0.0 : line.ArcLength.back() + step);
    line.Positions.push_back(position);
    line.Radii.push_back(radius);
  };
  const int count = static_cast<int>(limb.Joints.size());
  if (limb.IsSlab())
  {
    for (const Joint& joint : limb.Joints)
    {
      add(joint.Position, joint.Radius);
    }
    return line;
  }

  auto at = [&](int i)
  { return Control(limb.Joints[limb.Closed ? (i + count) % count : std::clamp(i, 0, count - 1)]); };
  auto chord = [&](int i) { return std::max(1e-12, (at(i + 1) - at(i)).head<3>().norm()); };
  // The tangent per unit of chord length of a parabola through three joints (secant at the ends).
  auto tangent = [&](int i) -> Eigen::Vector4d
  {
    if (!limb.Closed && (i == 0 || i == count - 1))
    {
      const int from = i == 0 ? 0 : count - 2;
      return (at(from + 1) - at(from)) / chord(from);
    }
    const double before = chord(i - 1);
    const double after = chord(i);
    return ((at(i) - at(i - 1)) / before * after + (at(i + 1) - at(i)) / after * before) /
      (before + after);
  };
  const int spans = limb.Closed ? count : count - 1;
  for (int i = 0; i < spans; ++i)
  {
    const double length = chord(i);
    const Eigen::Vector4d a = at(i);
    const Eigen::Vector4d b = at(i + 1);
    const Eigen::Vector4d ta = length * tangent(i);
    const Eigen::Vector4d tb = length * tangent(i + 1);
    for (int k = i == 0 ? 0 : 1; k <= CenterLine::SamplesPerSpan; ++k)
    {
      const double t = static_cast<double>(k) / CenterLine::SamplesPerSpan;
      const double s = 1.0 - t;
      const Eigen::Vector4d value =
        s * s * (1.0 + 2.0 * t) * a + t * t * (1.0 + 2.0 * s) * b + s * s * t * ta - t * t * s * tb;
      // Never thinner than the thinner joint: the cubic may swing below it.
      add(value.head<3>(), std::max(value[3], std::min(a[3], b[3])));
    }
  }
  return line;
}

ImplicitCreature::ImplicitCreature(const Creature& creature)
  : Source(creature)
{
  for (const Limb& limb : creature.Limbs)
  {
    this->Lines.push_back(SampleCenterLine(limb));
    const CenterLine& line = this->Lines.back();
    const int last = static_cast<int>(line.Positions.size()) - 1;
    this->LimbBalls.push_back(limb.IsSlab() ? Ball{ limb.Joints[0].Position, limb.Slab.norm() }
                                            : BallAround(line, 0, last));
    this->SpanBalls.emplace_back();
    for (int i = 0; i < last && !limb.IsSlab(); i += CenterLine::SamplesPerSpan)
    {
      this->SpanBalls.back().push_back(BallAround(line, i, i + CenterLine::SamplesPerSpan));
    }
  }
}

ImplicitCreature::Ball ImplicitCreature::BallAround(const CenterLine& line, int first, int last)
{
  Eigen::Vector3d low = line.Positions[first];
  Eigen::Vector3d high = low;
  for (int i = first; i <= last; ++i)
  {
    low = low.cwiseMin(line.Positions[i]);
    high = high.cwiseMax(line.Positions[i]);
  }
  Ball ball{ 0.5 * (low + high), 0.0 };
  for (int i = first; i <= last; ++i)
  {
    ball.Radius = std::max(ball.Radius, (line.Positions[i] - ball.Center).norm() + line.Radii[i]);
  }
  return ball;
}

ImplicitCreature::Nearest ImplicitCreature::ToLimb(
  int index, const Eigen::Vector3d& point, double limit) const
{
  const Limb& limb = this->Source.Limbs[index];
  const CenterLine& line = this->Lines[index];
  Nearest result{ limit, Eigen::Vector3d::UnitY(), 0.0 };
  if (limb.IsSlab())
  {
    // A box shrunk by its rounding, and the distance from that.
    const double rounding = limb.Joints[0].Radius * 0.95;
    const Eigen::Vector3d offset = point - limb.Joints[0].Position;
    const Eigen::Vector3d excess =
      offset.cwiseAbs() - (limb.Slab - Eigen::Vector3d::Constant(rounding));
    const Eigen::Vector3d outside = excess.cwiseMax(0.0);
    Eigen::Vector3d direction = outside;
    if (outside.isZero(0.0))
    {
      int axis = 0;
      result.Distance = excess.maxCoeff(&axis) - rounding;
      direction = Eigen::Vector3d::Unit(axis);
    }
    else
    {
      result.Distance = outside.norm() - rounding;
    }
    for (int k = 0; k < 3; ++k)
    {
      direction[k] = std::copysign(direction[k], offset[k]);
    }
    result.Direction = direction.normalized();
    return result;
  }

  for (std::size_t i = 0; i + 1 < line.Positions.size(); ++i)
  {
    const bool opensSpan = i % CenterLine::SamplesPerSpan == 0;
    if (opensSpan &&
      this->SpanBalls[index][i / CenterLine::SamplesPerSpan].Distance(point) > result.Distance)
    {
      i += CenterLine::SamplesPerSpan - 1;
      continue;
    }
    const Eigen::Vector3d& a = line.Positions[i];
    const double length = line.ArcLength[i + 1] - line.ArcLength[i];
    // A piece that cannot be nearer than the nearest so far is left out too.
    const double reach = result.Distance + length + std::max(line.Radii[i], line.Radii[i + 1]);
    if (length <= 0.0 || (reach > 0.0 && (point - a).squaredNorm() > reach * reach))
    {
      continue;
    }
    const Eigen::Vector3d axis = (line.Positions[i + 1] - a) / length;
    const double along = (point - a).dot(axis);
    const double aside = (point - a - along * axis).norm();
    const double t = RoundConeParameter(along, aside, length, line.Radii[i], line.Radii[i + 1]);
    const Eigen::Vector3d offset = point - a - t * axis;
    const double toCenter = offset.norm();
    const double radius = line.Radii[i] + (line.Radii[i + 1] - line.Radii[i]) * t / length;
    if (toCenter - radius < result.Distance)
    {
      result.Distance = toCenter - radius;
      result.Fraction = line.ArcLength[i] + t;
      result.Direction =
        toCenter > 0.0 ? Eigen::Vector3d(offset / toCenter) : Eigen::Vector3d::UnitY();
    }
  }
  result.Fraction /= line.ArcLength.back();
  return result;
}

double ImplicitCreature::Value(const Eigen::Vector3d& point) const
{
  Eigen::Vector3d gradient;
  return this->Value(point, gradient);
}

double ImplicitCreature::Value(const Eigen::Vector3d& point, Eigen::Vector3d& gradient) const
{
  double value = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(this->Lines.size()); ++i)
  {
    const double blend = this->Source.Limbs[i].Blend;
    if (this->LimbBalls[i].Distance(point) > value + blend)
    {
      continue;
    }
    const Nearest nearest = this->ToLimb(i, point, value + blend);
    // Quadratic smooth minimum: a convex combination of gradients, so the slope stays at most 1.
    const double difference = nearest.Distance - value;
    if (std::abs(difference) >= blend || i == 0)
    {
      if (difference < 0.0)
      {
        value = nearest.Distance;
        gradient = nearest.Direction;
      }
      continue;
    }
    const double weight = 0.5 * (1.0 - std::abs(difference) / blend);
    const double ofNearest = difference < 0.0 ? 1.0 - weight : weight;
    value = std::min(value, nearest.Distance) - weight * weight * blend;
    gradient = ofNearest * nearest.Direction + (1.0 - ofNearest) * gradient;
  }
  return value;
}

ImplicitCreature::Place ImplicitCreature::PlaceOf(const Eigen::Vector3d& point) const
{
  Place place;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(this->Lines.size()); ++i)
  {
    const Nearest nearest = this->ToLimb(i, point, least);
    if (nearest.Distance < least)
    {
      least = nearest.Distance;
      place = { i, nearest.Fraction };
    }
  }
  return place;
}

Eigen::Vector3d ImplicitCreature::Project(Eigen::Vector3d point) const
{
  for (int i = 0; i < 3; ++i)
  {
    Eigen::Vector3d gradient;
    const double value = this->Value(point, gradient);
    const double slope = gradient.squaredNorm();
    if (slope < 1e-4)
    {
      break; // on the crease of a medial axis: no direction to go
    }
    point -= value / slope * gradient;
  }
  return point;
}

void ImplicitCreature::Bounds(Eigen::Vector3d& low, Eigen::Vector3d& high) const
{
  low.setConstant(std::numeric_limits<double>::infinity());
  high = -low;
  double blend = 0.0;
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    const Limb& limb = this->Source.Limbs[i];
    blend = std::max(blend, limb.Blend);
    const CenterLine& line = this->Lines[i];
    for (std::size_t k = 0; k < line.Positions.size(); ++k)
    {
      const Eigen::Vector3d extent =
        limb.IsSlab() && k == 0 ? limb.Slab : Eigen::Vector3d::Constant(line.Radii[k]);
      low = low.cwiseMin(line.Positions[k] - extent);
      high = high.cwiseMax(line.Positions[k] + extent);
    }
  }
  low.array() -= blend;
  high.array() += blend;
}
}
