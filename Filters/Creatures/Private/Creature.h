// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Creature_h
#define marrow_Creature_h

#include "Variation.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace marrow
{
/// What can be made. The numbers are those of vtkCreatureSource's Shape.
enum class CreatureKind
{
  Biped = 0,
  Quadruped = 1,
  Octopus = 2,
  Chair = 3,
  Snake = 4,
  Torus = 5,
  Capsule = 6
};

/// A point of a limb's centre line. Angles in degrees at a variation of 1; x points to the front, y
/// up and z to the creature's right.
struct Joint
{
  Eigen::Vector3d Position;
  double Radius;
  Eigen::Vector3d Swing = Eigen::Vector3d::Zero(); ///< to both sides about the x, y and z axis
  double Flex = 0.0; ///< to one side about the z axis, for knees and elbows
};

/// A part with a centre line: the surface is at distance Radius from the smooth curve through the
/// joints.
struct Limb
{
  std::vector<Joint> Joints;
  int Parent = -1;      ///< limb that the first joint sits on; parents come before children
  int ParentJoint = -1; ///< the joint of it
  int End = -1;         ///< limb that the last joint sits on too, which makes a loop
  int EndJoint = -1;
  bool Closed = false; ///< the last joint is followed by the first
  /// Whether the way from the first to the second joint runs inside the parent, and so grows with
  /// the parent's girth and not with the limb's length.
  bool Buried = false;
  double Blend = 0.0; ///< width of the smooth transition to what the limb joins
  int Twins = -1;     ///< limbs of the same number have the same proportions
  /// Segment ids along the limb: each holds up to the given fraction of its length.
  std::vector<std::pair<double, int>> Segments;
  /// Not zero: a rounded box about the first joint instead of a curve, its half extents; the other
  /// joints are points inside it that other limbs sit on.
  Eigen::Vector3d Slab = Eigen::Vector3d::Zero();

  bool IsSlab() const { return this->Slab.x() > 0.0; }
  int SegmentAt(double fraction) const;
};

struct Creature
{
  std::vector<Limb> Limbs;
};

/// The creature with the proportions and in the pose that are drawn from the variations. Without
/// any, a symmetric one in its rest pose.
Creature MakeCreature(CreatureKind kind, Variation& proportion, Variation& pose);

/// Bends the joints of a tree of limbs; children follow their parents.
void ApplyPose(Creature& creature, Variation& pose);
}

#endif
