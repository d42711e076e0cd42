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
  double CentricityTolerance = 0.3; ///< of AGD
  double PathTolerance = 0.2;       ///< of path lengths over the longest path
  double SpatialTolerance = 0.35;   ///< share of the spread that no rotation explains
};

/// Electors voting: O. K.-C. Au, C.-L. Tai, D. Cohen-Or, Y. Zheng, H. Fu, "Electors voting for fast
/// automatic shape correspondence", Computer Graphics Forum 29(2), 2010; the peer of the correspondence
/// tree.
///
/// A search goes through the source's feature nodes and gives each one of the target's of the same kind
/// (terminal or junction), or none. A set of pairs is pruned as soon as it fails a test:
///   centricity: the AGD of two matched nodes is alike;
///   path length: so is the length of the path between two nodes and of that between their partners;
///   topology: a node lies between two others if and only if its partner lies between theirs;
///   spatial configuration: some rotation and scale, but no reflection, brings the positions of three
///   and more nodes to lie alike.
/// The sets that survive to the end are the electors. Each gives one vote to each of its pairs, and the
/// elector whose pairs have most votes wins; of several, the one whose tests came out best.
///
/// The paper leaves open how the sets are numbered that may leave nodes out; here, the search goes level
/// by level, from the node of the longest branches on, and each level keeps the `MaximumSets` sets that
/// leave out the fewest nodes and pass the tests best. So the work is bounded by FeaturePaths'
/// MaximumFeatures⁴ · MaximumSets / 2 cheap tests, whatever the skeletons. Where the winner matches less
/// than half of the nodes it could, the tolerances of centricity and path length are doubled, up to
/// twice.
class ElectorsVoting
{
public:
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
  /// A set of pairs that passed all tests.
  struct PairSet
  {
    std::vector<Pair> Pairs;
    double Misfit = 0.0; ///< of the pairs, and 1.5 for each node left out
    double Rank = 0.0;   ///< with the spatial misfit
    /// Of the positions, for the spatial test.
    Eigen::Vector3d SourceSum = Eigen::Vector3d::Zero();
    Eigen::Vector3d TargetSum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d Products = Eigen::Matrix3d::Zero();
    double SourceSquares = 0.0;
    double TargetSquares = 0.0;
  };

  std::vector<int> SearchOrder() const;
  bool Search(const Progress& progress);
  /// The set with one pair more; false if it fails a test.
  bool Extend(const PairSet& set, Pair added, PairSet& result) const;
  bool PassesCentricity(Pair pair) const;
  bool PassesTopology(const PairSet& set, Pair added) const;
  void AddPositions(PairSet& set, Pair added) const;
  /// In [0, 2]: what rotation and scale do not explain; negative for a reflection.
  static double SpatialMisfit(const PairSet& set);
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
