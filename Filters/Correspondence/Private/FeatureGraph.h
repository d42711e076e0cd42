// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FeatureGraph_h
#define marrow_FeatureGraph_h

#include "Skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// Junctions that are taken for one. A group of one feature node is the ordinary case.
struct FeatureGroup
{
  std::vector<int> Features; ///< ascending
  std::vector<int> Inside;   ///< the branches contracted by the merging, ascending

  bool Contains(int feature) const;
  bool operator==(const FeatureGroup& other) const { return this->Features == other.Features; }
};

/// What the matching sees of a skeleton: feature nodes and the branches between them.
///
/// A branch is used in both directions, so the matching speaks of darts: dart 2 b leaves the front
/// of branch b, dart 2 b + 1 its back. Features and branches are numbered by what they measure and
/// not by the numbers of the skeleton's points, so the result does not depend on those.
class FeatureGraph
{
public:
  /// One measure of the nodes, for Profile().
  enum class Measure
  {
    MSP, ///< divided by the mesh's largest
    AGD,
    Radius ///< divided by the mesh's diagonal
  };

  struct Feature
  {
    int Node = -1;      ///< of the skeleton
    int Component = -1; ///< in decreasing order of length
    double AGD = 0.0;
    double MSP = 0.0; ///< divided by the mesh's largest
    Eigen::Vector3d Position = Eigen::Vector3d::Zero();
    double Radius = 0.0;
    std::vector<int> Darts; ///< that leave it; both darts of a loop
    bool IsTerminal() const { return this->Darts.size() == 1; }
    bool IsJunction() const { return this->Darts.size() >= 3; }
  };

  /// `pieces` is the length of a branch's descriptor.
  FeatureGraph(const Skeleton& skeleton, int pieces);

  const std::vector<Feature>& GetFeatures() const { return this->Features; }
  int NumberOfFeatures() const { return static_cast<int>(this->Features.size()); }
  int NumberOfBranches() const { return static_cast<int>(this->Branches.size()); }
  int NumberOfComponents() const { return static_cast<int>(this->ComponentLengths.size()); }
  double ComponentLength(int component) const { return this->ComponentLengths[component]; }
  /// Of all branches; lengths below are fractions of it.
  double TotalLength() const { return this->Total; }
  double MeshDiagonal() const { return this->Diagonal; }

  int Origin(int dart) const { return this->FeatureOfDart[dart]; }
  int Head(int dart) const { return this->FeatureOfDart[dart ^ 1]; }
  /// The branch of the skeleton, and whether the dart runs against its direction.
  int SkeletonBranch(int dart) const { return this->Branches[dart / 2].Source; }
  bool RunsAgainst(int dart) const { return this->Branches[dart / 2].Flipped != (dart % 2 == 1); }
  double Length(int branch) const { return this->Branches[branch].Path.Length() / this->Total; }
  double Length(const std::vector<int>& darts) const;
  /// Whether the branch is in the minimum spanning forest: a loop is opened at its longest branch.
  bool IsInForest(int branch) const { return this->Forest[branch]; }

  struct ShortestPaths
  {
    std::vector<double> Length; ///< per feature, infinite if there is no way
    std::vector<int> Arrival;   ///< per feature the last dart of the way, -1 for none
  };
  /// The shortest ways from a feature to all others (Dijkstra), if told so only over the forest.
  ShortestPaths ShortestPathsFrom(int feature, bool inForest) const;

  /// The nodes of a branch, from the origin of its even dart on.
  const std::vector<int>& NodesOf(int branch) const { return this->Branches[branch].Path.Nodes; }
  /// The shortest ways over the forest from any node of the skeleton to all features.
  std::vector<double> DistancesFromNode(int node) const;

  /// The darts that leave a group, ascending; both darts of a loop.
  std::vector<int> OpenDarts(const FeatureGroup& group) const;
  /// |g| of the sub-skeleton behind each of the group's open darts (method 3.2).
  std::vector<double> SubSkeletonSizes(
    const FeatureGroup& group, const std::vector<int>& openDarts) const;
  /// Unit direction of the part of the branch inside the group's inscribed ball.
  Eigen::Vector3d Direction(const FeatureGroup& group, int dart) const;
  double AGD(const FeatureGroup& group) const;

  /// The mean of a measure along each of `pieces` equal pieces of a path of darts.
  std::vector<double> Profile(const std::vector<int>& darts, Measure measure, int pieces) const;
  /// The MSP descriptor of a dart.
  const std::vector<double>& Descriptor(int dart) const { return this->Descriptors[dart]; }
  /// The point at a fraction of a path's length.
  Eigen::Vector3d PointAt(const std::vector<int>& darts, double fraction) const;

private:
  struct OrientedBranch
  {
    int Source = -1;
    bool Flipped = false;
    Branch Path;
  };
  void SmoothPositions();
  void AddFeatures();
  void FindComponents();
  void FindForest();
  double Value(int node, Measure measure) const;
  static Branch Reversed(const Branch& branch);
  /// The nodes of a path and their arc length, in mesh units.
  Branch Concatenate(const std::vector<int>& darts) const;

  const Skeleton& Bones;
  /// Of the skeleton's nodes, without zigzag: it would make lengths a matter of chance.
  std::vector<Eigen::Vector3d> Positions;
  std::vector<OrientedBranch> Branches;
  std::vector<Feature> Features;
  std::vector<int> FeatureOfDart;
  std::vector<double> ComponentLengths;
  std::vector<bool> Forest;
  std::vector<std::vector<double>> Descriptors;
  double Total = 0.0;
  double Diagonal = 0.0;
};

/// Root of the mean squared difference of two profiles of one length.
double ProfileDistance(const std::vector<double>& a, const std::vector<double>& b);
}

#endif
