// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Hints_h
#define marrow_Hints_h

#include <Eigen/Core>

namespace marrow
{
/// The user's word on two places: they are of the same part, or must not be taken for that.
struct PointHint
{
  Eigen::Vector3d Source = Eigen::Vector3d::Zero();
  Eigen::Vector3d Target = Eigen::Vector3d::Zero();
  bool IsForbidden = false;
};

/// The same on two nodes of the skeletons.
struct NodeHint
{
  int SourceNode = -1;
  int TargetNode = -1;
  bool IsForbidden = false;
};
}

#endif
