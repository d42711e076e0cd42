// SPDX-License-Identifier: BSD-3-Clause
#include "Creature.h"

#include "Constants.h"

#include <cmath>

namespace marrow
{
namespace
{
Limb MakeLimb(int segment, int parent, int parentJoint, double blend, std::vector<Joint> joints)
{
  Limb limb;
  limb.Segments = { { 1.0, segment } };
  limb.Parent = parent;
  limb.ParentJoint = parentJoint;
  limb.Blend = blend;
  limb.Joints = std::move(joints);
  return limb;
}

/// A limb on the right (z > 0) and its mirror image on the left.
void AddPair(Creature& creature, Limb right, int leftSegment)
{
  right.Twins = static_cast<int>(creature.Limbs.size());
  Limb left = right;
  left.Segments = { { 1.0, leftSegment } };
  for (Joint& joint : left.Joints)
  {
    joint.Position.z() = -joint.Position.z();
  }
  creature.Limbs.push_back(std::move(right));
  creature.Limbs.push_back(std::move(left));
}

Creature MakeBiped()
{
  Creature creature;
  creature.Limbs.push_back(MakeLimb(0, -1, -1, 0.0,
    { { { 0.0, 0.98, 0.0 }, 0.165 }, { { 0.0, 1.2, 0.0 }, 0.155, { 8, 12, 12 } },
      { { 0.0, 1.42, 0.0 }, 0.185 } }));
  creature.Limbs.push_back(MakeLimb(1, 0, 2, 0.05,
    { { { 0.0, 1.42, 0.0 }, 0.09, { 6, 10, 10 } }, { { 0.01, 1.62, 0.0 }, 0.08, { 6, 10, 10 } },
      { { 0.02, 1.82, 0.0 }, 0.075 } }));
  creature.Limbs.push_back(MakeLimb(2, 1, 2, 0.05,
    { { { 0.02, 1.82, 0.0 }, 0.11, { 8, 20, 15 } }, { { 0.05, 1.92, 0.0 }, 0.135 },
      { { 0.05, 1.99, 0.0 }, 0.12 } }));
  Limb arm = MakeLimb(3, 0, 2, 0.06,
    { { { 0.0, 1.42, 0.0 }, 0.1 }, { { 0.0, 1.49, 0.21 }, 0.088, { 20, 15, 35 } },
      { { -0.02, 1.24, 0.42 }, 0.066, { 0, 15, 0 }, 60.0 },
      { { 0.02, 0.99, 0.59 }, 0.05, { 10, 0, 10 } }, { { 0.05, 0.84, 0.68 }, 0.055 } });
  arm.Buried = true;
  AddPair(creature, arm, 4);
  Limb leg = MakeLimb(5, 0, 0, 0.05,
    { { { 0.0, 0.98, 0.0 }, 0.12 }, { { 0.0, 0.9, 0.135 }, 0.11, { 6, 5, 30 } },
      { { 0.02, 0.52, 0.17 }, 0.078, { 0, 0, 0 }, -50.0 },
      { { -0.02, 0.12, 0.19 }, 0.056, { 0, 5, 10 } }, { { 0.14, 0.06, 0.21 }, 0.05 } });
  leg.Buried = true;
  AddPair(creature, leg, 6);
  return creature;
}

Creature MakeQuadruped()
{
  Creature creature;
  creature.Limbs.push_back(MakeLimb(0, -1, -1, 0.0,
    { { { -0.52, 1.0, 0.0 }, 0.25 }, { { 0.0, 0.97, 0.0 }, 0.27, { 5, 12, 8 } },
      { { 0.52, 1.02, 0.0 }, 0.28 } }));
  creature.Limbs.push_back(MakeLimb(1, 0, 2, 0.12,
    { { { 0.52, 1.02, 0.0 }, 0.18, { 5, 15, 15 } }, { { 0.88, 1.35, 0.0 }, 0.15, { 5, 15, 15 } },
      { { 1.08, 1.68, 0.0 }, 0.12 } }));
  creature.Limbs.push_back(MakeLimb(2, 1, 2, 0.06,
    { { { 1.08, 1.68, 0.0 }, 0.165, { 10, 20, 15 } }, { { 1.28, 1.63, 0.0 }, 0.145 },
      { { 1.55, 1.5, 0.0 }, 0.095 } }));
  Limb front = MakeLimb(3, 0, 2, 0.08,
    { { { 0.52, 1.02, 0.0 }, 0.15 }, { { 0.54, 0.88, 0.18 }, 0.135, { 5, 0, 25 } },
      { { 0.5, 0.52, 0.2 }, 0.09, { 0, 0, 0 }, -35.0 },
      { { 0.54, 0.12, 0.2 }, 0.068, { 0, 0, 20 } }, { { 0.58, 0.05, 0.2 }, 0.068 } });
  front.Buried = true;
  AddPair(creature, front, 4);
  Limb back = MakeLimb(5, 0, 0, 0.08,
    { { { -0.52, 1.0, 0.0 }, 0.17 }, { { -0.52, 0.88, 0.17 }, 0.155, { 5, 0, 25 } },
      { { -0.42, 0.55, 0.2 }, 0.1, { 0, 0, 10 } },
      { { -0.58, 0.32, 0.2 }, 0.068, { 0, 0, 10 }, 25.0 }, { { -0.54, 0.05, 0.2 }, 0.068 } });
  back.Buried = true;
  AddPair(creature, back, 6);
  creature.Limbs.push_back(MakeLimb(7, 0, 0, 0.06,
    { { { -0.52, 1.0, 0.0 }, 0.075 }, { { -0.82, 1.1, 0.0 }, 0.065, { 0, 25, 20 } },
      { { -1.02, 0.98, 0.0 }, 0.055, { 0, 20, 15 } }, { { -1.12, 0.72, 0.0 }, 0.05, { 10, 0, 15 } },
      { { -1.15, 0.5, 0.0 }, 0.045 } }));
  return creature;
}

Creature MakeOctopus()
{
  Creature creature;
  creature.Limbs.push_back(MakeLimb(0, -1, -1, 0.0,
    { { { 0.0, 0.35, 0.0 }, 0.33 }, { { -0.05, 0.75, 0.0 }, 0.36, { 20, 0, 20 } },
      { { -0.12, 1.3, 0.0 }, 0.24 } }));
  for (int i = 0; i < 8; ++i)
  {
    const double angle = (i + 0.5) * Pi / 4.0;
    auto at = [angle](double distance, double height)
    { return Eigen::Vector3d(distance * std::cos(angle), height, distance * std::sin(angle)); };
    Limb tentacle = MakeLimb(i + 1, 0, 0, 0.05,
      { { { 0.0, 0.35, 0.0 }, 0.09 }, { at(0.4, 0.19), 0.09, { 0, 3, 0 } },
        { at(0.75, 0.12), 0.088, { 15, 25, 15 } }, { at(1.15, 0.1), 0.082, { 25, 40, 25 } },
        { at(1.55, 0.11), 0.074, { 30, 50, 30 } }, { at(1.9, 0.12), 0.068 } });
    tentacle.Buried = true;
    tentacle.Twins = 100; // of equal length, as far as a tentacle goes
    creature.Limbs.push_back(std::move(tentacle));
  }
  return creature;
}

Creature MakeSnake()
{
  Creature creature;
  Limb body = MakeLimb(0, -1, -1, 0.0, {});
  const int last = 12;
  for (int i = 0; i <= last; ++i)
  {
    // From the tail to the head: a slender tail, a neck, a head.
    static const double radius[last + 1] = { 0.04, 0.06, 0.085, 0.105, 0.115, 0.12, 0.12, 0.12,
      0.115, 0.105, 0.085, 0.12, 0.07 };
    const double x = i < last ? 0.36 * i : 0.36 * i - 0.1;
    const double z = 0.18 * std::sin(Pi * i / 3.0);
    body.Joints.push_back({ { x, 0.12, z }, radius[i], { 0.0, 24.0, 6.0 } });
  }
  body.Segments = { { 0.2, 2 }, { 0.845, 0 }, { 1.0, 1 } };
  creature.Limbs.push_back(std::move(body));
  return creature;
}

Creature MakeTorus()
{
  Creature creature;
  Limb ring = MakeLimb(0, -1, -1, 0.0, {});
  ring.Closed = true;
  for (int i = 0; i < 16; ++i)
  {
    const double angle = i * Pi / 8.0;
    ring.Joints.push_back({ { std::cos(angle), 0.0, std::sin(angle) }, 0.3 });
  }
  ring.Segments = { { 0.5, 0 }, { 1.0, 1 } };
  creature.Limbs.push_back(std::move(ring));
  return creature;
}

Creature MakeCapsule()
{
  Creature creature;
  Limb limb = MakeLimb(0, -1, -1, 0.0,
    { { { -1.0, 0.0, 0.0 }, 0.3 }, { { -0.35, 0.0, 0.0 }, 0.3, { 0, 30, 30 } },
      { { 0.35, 0.0, 0.0 }, 0.3, { 0, 30, 30 } }, { { 1.0, 0.0, 0.0 }, 0.3 } });
  limb.Segments = { { 0.25, 0 }, { 0.75, 1 }, { 1.0, 2 } };
  creature.Limbs.push_back(std::move(limb));
  return creature;
}

/// The chair's loops fix both ends of a limb, so it is built in its pose: the legs splay, the back
/// leans, the armrests follow.
Creature MakeChair(Variation& proportion, Variation& pose)
{
  const double width = 0.38 * proportion.Factor(1.2);
  const double depth = 0.38 * proportion.Factor(1.2);
  const double height = 0.85 * proportion.Factor(1.35);
  const double back = proportion.Factor(1.3);
  const double thick = proportion.Factor(1.2);
  const double leg = 0.065 * thick;
  const double rail = 0.06 * thick;
  const double lean = std::tan((8.0 + pose.Symmetric(10.0)) * Pi / 180.0);
  const double splay = std::tan((4.0 + pose.Symmetric(8.0)) * Pi / 180.0);

  Creature creature;
  Limb seat = MakeLimb(0, -1, -1, 0.0, { { { 0.0, height, 0.0 }, 0.11 } });
  seat.Slab = Eigen::Vector3d(depth + 0.1, 0.11, width + 0.1);
  // Front right and left, back right and left; where the armrests stand on.
  const double corners[6][2] = { { depth, width }, { depth, -width }, { -depth, width },
    { -depth, -width }, { 0.55 * depth, width }, { 0.55 * depth, -width } };
  for (const auto& corner : corners)
  {
    seat.Joints.push_back({ { corner[0], height, corner[1] }, 0.11 });
  }
  creature.Limbs.push_back(seat);

  auto onBack = [&](double rise, double z)
  { return Eigen::Vector3d(-depth - lean * back * rise, height + back * rise, z); };
  Limb backrest = MakeLimb(1, 0, 3, 0.05,
    { { onBack(0.0, width), rail }, { onBack(0.5, width), rail }, { onBack(0.9, width), rail },
      { onBack(1.08, 0.8 * width), rail }, { onBack(1.12, 0.0), rail },
      { onBack(1.08, -0.8 * width), rail }, { onBack(0.9, -width), rail },
      { onBack(0.5, -width), rail }, { onBack(0.0, -width), rail } });
  backrest.End = 0;
  backrest.EndJoint = 4;
  creature.Limbs.push_back(backrest);

  for (int side = 0; side < 2; ++side)
  {
    const double z = side == 0 ? width : -width;
    const double out = side == 0 ? 0.04 : -0.04;
    const Eigen::Vector3d post = onBack(0.5, z);
    Limb arm = MakeLimb(2 + side, 1, side == 0 ? 1 : 7, 0.04,
      { { post, 0.8 * rail }, { { -0.3 * depth, post.y() + 0.02, z + out }, 0.8 * rail },
        { { 0.45 * depth, post.y() - 0.02, z + out }, 0.8 * rail },
        { { 0.62 * depth, post.y() - 0.15 * back, z + out }, 0.8 * rail },
        { { 0.55 * depth, height, z }, 0.8 * rail } });
    arm.End = 0;
    arm.EndJoint = 5 + side;
    creature.Limbs.push_back(arm);
  }
  for (int i = 0; i < 4; ++i)
  {
    const double x = corners[i][0];
    const double z = corners[i][1];
    const double outX = std::copysign(splay * height, x);
    const double outZ = std::copysign(splay * height, z);
    creature.Limbs.push_back(MakeLimb(4 + i, 0, 1 + i, 0.05,
      { { { x, height, z }, leg }, { { x + 0.5 * outX, 0.5 * height, z + 0.5 * outZ }, leg },
        { { x + outX, leg, z + outZ }, 0.85 * leg } }));
  }
  return creature;
}

void ApplyProportion(Creature& creature, Variation& proportion)
{
  struct Factors
  {
    int Twins;
    double Length;
    double Girth;
  };
  std::vector<Factors> factors;
  const Creature rest = creature;
  for (std::size_t i = 0; i < creature.Limbs.size(); ++i)
  {
    Limb& limb = creature.Limbs[i];
    const std::vector<Joint>& restJoints = rest.Limbs[i].Joints;
    // Drawn for every limb, so that which limbs are twins does not shift the stream.
    Factors own{ limb.Twins, proportion.Factor(1.35), proportion.Factor(1.2) };
    for (const Factors& other : factors)
    {
      if (limb.Twins >= 0 && other.Twins == limb.Twins)
      {
        own = other;
        break;
      }
    }
    factors.push_back(own);
    if (limb.Parent >= 0)
    {
      limb.Joints[0].Position = creature.Limbs[limb.Parent].Joints[limb.ParentJoint].Position;
    }
    for (std::size_t j = 0; j < limb.Joints.size(); ++j)
    {
      limb.Joints[j].Radius *= own.Girth;
      if (j > 0)
      {
        const double length = j == 1 && limb.Buried ? factors[limb.Parent].Girth : own.Length;
        limb.Joints[j].Position = limb.Joints[j - 1].Position +
          length * (restJoints[j].Position - restJoints[j - 1].Position);
      }
    }
  }
}
}

int Limb::SegmentAt(double fraction) const
{
  for (const auto& [upTo, segment] : this->Segments)
  {
    if (fraction <= upTo)
    {
      return segment;
    }
  }
  return this->Segments.back().second;
}

Creature MakeCreature(CreatureKind kind, Variation& proportion, Variation& pose)
{
  Creature creature;
  switch (kind)
  {
    case CreatureKind::Biped:
      creature = MakeBiped();
      break;
    case CreatureKind::Quadruped:
      creature = MakeQuadruped();
      break;
    case CreatureKind::Octopus:
      creature = MakeOctopus();
      break;
    case CreatureKind::Chair:
      return MakeChair(proportion, pose);
    case CreatureKind::Snake:
      creature = MakeSnake();
      break;
    case CreatureKind::Torus:
      creature = MakeTorus();
      break;
    case CreatureKind::Capsule:
      creature = MakeCapsule();
      break;
  }
  ApplyProportion(creature, proportion);
  ApplyPose(creature, pose);
  return creature;
}
}
