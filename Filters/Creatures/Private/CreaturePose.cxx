// SPDX-License-Identifier: BSD-3-Clause
#include "Constants.h"
#include "Creature.h"

#include <Eigen/Geometry>

namespace marrow
{
void ApplyPose(Creature& creature, Variation& pose)
{
  constexpr double Degree = Pi / 180.0;
  const Creature rest = creature;
  // Per limb and joint: the rotation of what comes after the joint.
  std::vector<std::vector<Eigen::Quaterniond>> rotations(creature.Limbs.size());
  for (std::size_t i = 0; i < creature.Limbs.size(); ++i)
  {
    Limb& limb = creature.Limbs[i];
    const std::vector<Joint>& restJoints = rest.Limbs[i].Joints;
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    if (limb.Parent >= 0)
    {
      rotation = rotations[limb.Parent][limb.ParentJoint];
      limb.Joints[0].Position = creature.Limbs[limb.Parent].Joints[limb.ParentJoint].Position;
    }
    for (std::size_t j = 0; j < limb.Joints.size(); ++j)
    {
      if (j > 0)
      {
        limb.Joints[j].Position = limb.Joints[j - 1].Position +
          rotation * (restJoints[j].Position - restJoints[j - 1].Position);
      }
      const Joint& joint = restJoints[j];
      // One statement each: the order of the draws must not be the compiler's choice.
      const double x = Degree * pose.Symmetric(joint.Swing.x());
      const double y = Degree * pose.Symmetric(joint.Swing.y());
      const double z = Degree * (pose.Symmetric(joint.Swing.z()) + pose.OneSided(joint.Flex));
      rotation = rotation * Eigen::AngleAxisd(y, Eigen::Vector3d::UnitY()) *
        Eigen::AngleAxisd(z, Eigen::Vector3d::UnitZ()) *
        Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX());
      rotations[i].push_back(rotation);
    }
  }
}
}
