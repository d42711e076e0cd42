// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ElectorsVoting_h
#define marrow_ElectorsVoting_h

#include "FeatureCorrespondence.h"
#include "FeaturePaths.h"
#include "Progress.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace marrow
{
struct VotingParameters
{
  double CentricityTolerance = 0.4; ///< of AGD; default of vtkSkeletonCorrespondence
  double PathTolerance = 0.3;       ///< of path lengths over the longest path; likewise
  double SpatialTolerance = 0.35;   ///< share of the spread that no rotation explains; likewise
};

/// Electors voting: O. K.-C. Au, C.-L. Tai, D. Cohen-Or, Y. Zheng, H. Fu, "Electors voting for fast
/// automatic shape correspondence", Computer Graphics Forum 29(2), 2010; the peer of the correspondence
/// tree.
///
/// A search goes through the source's feature nodes and gives each one of the target's of the same kind
/// (terminal or junction), or none. A set of pairs is pruned as soon as it fails a test:
///   centricity: the AGD of two matched nodes is alike;
///   path length: so is the length of the path between two nodes and of that between their partners;
///   topology: a node lies between two others if and only if its partner lies between theirs (ours: or
///   both are near the paths, as where a junction is split in two);
///   spatial configuration: some rotation and scale, but no reflection, brings the positions of three
///   and more nodes to lie alike.
/// The sets that survive to the end are the electors. Each gives one vote to each of its pairs. The
/// pairs of most votes that pass the tests together win; of two with as many votes, the one that the
/// set of the better tests contains.
///
/// The number of sets grows fast where nodes may be left out. So here, the search goes level by level,
/// from the node of the longest branches on, and each level keeps the MaximumSets sets that leave out the
/// fewest nodes and pass the tests best. With n nodes of FeaturePaths at most, the work is bounded by
/// MaximumSets · n⁴ / 6 tests of a few operations, whatever the skeletons. Where the winner matches less
/// than half of the nodes it could, the tolerances of centricity and path length are doubled, up to
/// twice.
class ElectorsVoting
{
public:
  /// Work and memory are bounded by it.
  static constexpr std::size_t MaximumSets = 1000;

  ElectorsVoting(
    const FeatureGraph& source, const FeatureGraph& target, const VotingParameters& parameters);

  /// False if `progress` asked to stop.
  bool Vote(const Progress& progress);

  /// The winner; empty if no node has a partner.
  const FeatureCorrespondence& GetMatch() const { return this->Match; }
  /// TreeNodes: sets kept; Height: nodes searched; CorePairs: pairs that pass the test of centricity;
  /// Merges: junctions that matched chains pass; Leaves: electors.
  const TreeStatistics& GetStatistics() const { return this->Statistics; }

private:
  using Pair = std::pair<int, int>;
  /// How well a set of pairs passes the tests.
  struct Rating
  {
    double Misfit = 0.0; ///< of the pairs, and a constant for each node left out
    double Rank = 0.0;   ///< with the spatial misfit
    /// Sums over the positions, for the spatial test.
    int Count = 0;
    Eigen::Vector3d SourceSum = Eigen::Vector3d::Zero();
    Eigen::Vector3d TargetSum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d Products = Eigen::Matrix3d::Zero();
    double SourceSquares = 0.0;
    double TargetSquares = 0.0;
  };
  /// A set of pairs that passed all tests.
  struct PairSet
  {
    std::vector<Pair> Pairs;
    Rating Rated;
  };

  std::vector<int> SearchOrder() const;
  bool Search(const Progress& progress);
  /// The sets of the next level, with this feature of the source or without.
  std::vector<PairSet> NextLevel(int feature);
  /// Rates the set with one pair more; false if it fails a test.
  bool Extend(const PairSet& set, Pair added, Rating& rating) const;
  bool PassesCentricity(Pair pair) const;
  bool PassesTopology(const PairSet& set, Pair added) const;
  void AddPositions(Pair added, Rating& rating) const;
  /// In [0, 2]: what rotation and scale do not explain; negative for a reflection.
  static double SpatialMisfit(const Rating& rating);
  /// The pairs that win.
  PairSet Elect() const;

  const FeaturePaths Source;
  const FeaturePaths Target;
  VotingParameters Parameters;
  double Relaxation = 1.0;
  std::vector<PairSet> Electors;
  FeatureCorrespondence Match;
  TreeStatistics Statistics;
};
}

#endif
