// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PointTree_h
#define marrow_PointTree_h

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// A k-d tree for searches that begin with a guess: how far the nearest points are at most is known from an
/// earlier search nearby, and nothing beyond is looked at.
class PointTree
{
public:
  PointTree() = default;
  explicit PointTree(const std::vector<Eigen::Vector3d>& points);
  /// Only the points with these numbers.
  PointTree(const std::vector<Eigen::Vector3d>& points, std::vector<int> numbers);

  /// Calls visit(number, squared distance) for every point within the reach, and some beyond it, the
  /// nearer parts of the tree first. The reach is what the last call returned, `squaredReach` at first. A
  /// place that is not a number is as near to all.
  template <typename Visit>
  void Search(const Eigen::Vector3d& place, double squaredReach, Visit&& visit) const
  {
    if (!this->Nodes.empty())
    {
      this->Descend(0, place, Eigen::Vector3d::Zero(), squaredReach, visit);
    }
  }

private:
  /// A half is either a leaf of some points, or split again.
  struct Node
  {
    int Axis = -1; ///< -1: a leaf
    double Split = 0.0;
    int Begin = 0; ///< of a leaf's points
    int End = 0;
    int Second = 0; ///< the half above the split; the one below follows its parent
  };

  void Build(const std::vector<Eigen::Vector3d>& points, int begin, int end);

  /// `off` is how far `place` lies off the node's box, axis by axis.
  template <typename Visit>
  void Descend(int at, const Eigen::Vector3d& place, const Eigen::Vector3d& off,
    double& squaredReach, Visit& visit) const
  {
    const Node& node = this->Nodes[at];
    if (node.Axis < 0)
    {
      for (int i = node.Begin; i < node.End; ++i)
      {
        const double squared = (this->Points[i] - place).squaredNorm();
        if (!(squared > squaredReach))
        {
          squaredReach = visit(this->Numbers[i], squared);
        }
      }
      return;
    }
    const double beyond = place[node.Axis] - node.Split;
    this->Descend(beyond < 0.0 ? at + 1 : node.Second, place, off, squaredReach, visit);
    Eigen::Vector3d offOther = off;
    offOther[node.Axis] = beyond;
    if (!(offOther.squaredNorm() > squaredReach))
    {
      this->Descend(beyond < 0.0 ? node.Second : at + 1, place, offOther, squaredReach, visit);
    }
  }

  std::vector<Node> Nodes;
  std::vector<int> Numbers;
  std::vector<Eigen::Vector3d> Points; ///< in the order of Numbers
};
}

#endif
