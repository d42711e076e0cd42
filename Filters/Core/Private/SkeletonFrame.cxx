// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonFrame.h"

#include "BinaryScale.h"

#include <numeric>

namespace marrow
{
namespace
{
template <typename MovePoint, typename ScaleLength>
void Convert(Skeleton& skeleton, MovePoint&& movePoint, ScaleLength&& scaleLength)
{
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    SkeletonNode& node = skeleton.Graph[n];
    node.Position = movePoint(node.Position);
    node.MSP = scaleLength(node.MSP);
    node.Radius = scaleLength(node.Radius);
  }
  skeleton.MeshDiagonal = scaleLength(skeleton.MeshDiagonal);
  skeleton.MeshMaximumMSP = scaleLength(skeleton.MeshMaximumMSP);
  skeleton.UpdateArcLengths();
}
}

Skeleton ToFrame(Skeleton skeleton, const CanonicalFrame& frame)
{
  Convert(
    skeleton, [&](const Eigen::Vector3d& point) { return frame.ToFrame(point); },
    [&](double length) { return frame.LengthToFrame(length); });
  return skeleton;
}

Skeleton FromFrame(Skeleton skeleton, const CanonicalFrame& frame)
{
  Convert(
    skeleton, [&](const Eigen::Vector3d& point) { return frame.FromFrame(point); },
    [&](double length) { return frame.LengthFromFrame(length); });
  return skeleton;
}

CanonicalFrame FrameOf(const Skeleton& skeleton)
{
  std::vector<Eigen::Vector3d> positions;
  std::vector<double> weights(skeleton.NumberOfNodes(), 0.0);
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    positions.push_back(skeleton.Graph[n].Position);
  }
  std::vector<int> all(positions.size());
  std::iota(all.begin(), all.end(), 0);
  const int exponent = ScaleExponent(positions, all);
  Scale(positions, -exponent);
  for (const Branch& branch : skeleton.Branches)
  {
    for (std::size_t i = 1; i < branch.Nodes.size(); ++i)
    {
      const double half =
        0.5 * (positions[branch.Nodes[i]] - positions[branch.Nodes[i - 1]]).norm();
      weights[branch.Nodes[i]] += half;
      weights[branch.Nodes[i - 1]] += half;
    }
  }
  CanonicalFrame frame(positions, weights);
  frame.Scale(exponent);
  return frame;
}
}
