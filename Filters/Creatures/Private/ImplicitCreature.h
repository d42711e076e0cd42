// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ImplicitCreature_h
#define marrow_ImplicitCreature_h

#include "Creature.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// A limb's centre line, sampled: SamplesPerSpan pieces between two joints, so that joint j is
/// sample SamplesPerSpan * j. A closed limb ends with its first sample again.
struct CenterLine
{
  static constexpr int SamplesPerSpan = 8;

  std::vector<Eigen::Vector3d> Positions;
  std::vector<double> Radii;
  std::vector<double> ArcLength;
};

/// A cubic through the joints, radius included. Only the joints of a slab, unsampled.
CenterLine SampleCenterLine(const Limb& limb);

/// The creature as the zero set of a function that is negative inside and changes no faster than
/// distance does, so that its value bounds how far the surface is.
class ImplicitCreature
{
public:
  explicit ImplicitCreature(const Creature& creature);

  double Value(const Eigen::Vector3d& point) const;
  /// The value, and the gradient.
  double Value(const Eigen::Vector3d& point, Eigen::Vector3d& gradient) const;

  /// The limb whose own surface is nearest (deepest, inside), and where along it, in [0,1].
  struct Place
  {
    int Limb = 0;
    double Fraction = 0.0;
  };
  Place PlaceOf(const Eigen::Vector3d& point) const;

  /// The point moved along the gradient onto the surface.
  Eigen::Vector3d Project(Eigen::Vector3d point) const;

  const std::vector<CenterLine>& CenterLines() const { return this->Lines; }
  /// A box that holds the surface.
  void Bounds(Eigen::Vector3d& low, Eigen::Vector3d& high) const;

private:
  struct Ball
  {
    Eigen::Vector3d Center;
    double Radius;

    double Distance(const Eigen::Vector3d& point) const
    {
      return (point - this->Center).norm() - this->Radius;
    }
  };
  static Ball BallAround(const CenterLine& line, int first, int last);
  struct Nearest
  {
    double Distance;
    Eigen::Vector3d Direction;
    double Fraction;
  };
  /// The limb's own surface, as far as it is nearer than `limit`.
  Nearest ToLimb(int limb, const Eigen::Vector3d& point, double limit) const;

  const Creature& Source;
  std::vector<CenterLine> Lines;
  // Around the surface of each limb and of each of its spans, to leave out what is far.
  std::vector<Ball> LimbBalls;
  std::vector<std::vector<Ball>> SpanBalls;
};
}

#endif
