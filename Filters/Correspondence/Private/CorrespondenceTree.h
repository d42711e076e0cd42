// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CorrespondenceTree_h
#define marrow_CorrespondenceTree_h

#include "FeatureCorrespondence.h"
#include "Progress.h"

#include <vector>

namespace marrow
{
struct TreeParameters
{
  double JunctionThreshold = 0.02; ///< C_J
  double MergeDistance = 0.075;    ///< d_J, of the mesh's diagonal
  double ClusterDistance = 0.1;    ///< λ_B
};

/// The correspondence tree of two skeletons (correspondence paper, Algorithms 1 to 4).
///
/// Beyond the paper: an assignment of branches is rated by what the branches are like and not only
/// by where they point; a cluster matched with a branch that is in none costs instead of being
/// forbidden; mergings that lower a junction's cost clearly are tried even if the pair would pass
/// without; where no pair of junctions passes C_J, the best one is taken up to 4 C_J; each level of
/// the tree keeps its best nodes only, so that the tree stays small whatever the skeletons.
class CorrespondenceTree
{
public:
  CorrespondenceTree(
    const FeatureGraph& source, const FeatureGraph& target, const TreeParameters& parameters);

  /// Grows the tree. False if `progress` asked to stop.
  bool Grow(const Progress& progress);

  /// In the order of the tree, without repetitions.
  const std::vector<FeatureCorrespondence>& GetLeaves() const { return this->Leaves; }
  const TreeStatistics& GetStatistics() const { return this->Statistics; }

private:
  /// A pair of branches that is less like than this is rather a loss than a gain.
  static constexpr double WorthMatching = 0.5;
  /// Junctions that are merged at most.
  static constexpr int MaximumGroup = 4;
  /// A branch or node not used yet; what a matched chain passed over; else the index of its pair.
  static constexpr int Free = -1;
  static constexpr int Passed = -2;

  struct Side
  {
    std::vector<int> Features; ///< Free, Passed or the matched nodes' index
    std::vector<bool> Used;    ///< per branch
  };
  struct Task
  {
    bool IsJunction;
    int Index; ///< of matched nodes whose branches, or of matched branches whose ends are next
  };
  struct TreeNode
  {
    FeatureCorrespondence Match;
    Side Source;
    Side Target;
    std::vector<Task> Tasks; ///< first in, first out
    std::size_t NextTask = 0;
    std::size_t NextComponent = 0;
    double Gain = 0.0; ///< decides which nodes of a level are kept
  };
  /// A way on for two branches whose ends are not matched yet.
  struct Continuation
  {
    std::vector<int> SourcePath; ///< darts to append
    std::vector<int> TargetPath;
    FeatureGroup Source;
    FeatureGroup Target;
    bool IsJunction = false;
    double Cost = 0.0;   ///< C_junc, or of terminals how unlike the branches are
    double Rating = 0.0; ///< Cost and what the mergings cost
    int Merges = 0;
  };

  /// Goes on from a node; one without children is complete then.
  std::vector<TreeNode> Expand(TreeNode& node);
  std::vector<TreeNode> StartComponent(const TreeNode& node);
  std::vector<TreeNode> StartAtJunctions(const TreeNode& node, int source, int target);
  std::vector<TreeNode> StartAlongPaths(const TreeNode& node, int source, int target);
  std::vector<TreeNode> MatchBranches(const TreeNode& node, int nodes);
  std::vector<TreeNode> MatchEnds(const TreeNode& node, int branches);
  std::vector<Continuation> FindContinuations(
    const TreeNode& node, const MatchedBranches& branches) const;
  void AddJunctionContinuations(const TreeNode& node, const Continuation& paths, int sourceEnd,
    int targetEnd, std::vector<Continuation>& result) const;
  std::vector<Continuation> ChooseContinuations(std::vector<Continuation> all) const;

  int AddNodes(
    TreeNode& node, const FeatureGroup& source, const FeatureGroup& target, bool isJunction) const;
  void AddBranches(TreeNode& node, const std::vector<int>& source, const std::vector<int>& target,
    int first) const;
  void PairComponents();
  void AddLeaf(const TreeNode& node);

  const FeatureGraph& SourceGraph;
  const FeatureGraph& TargetGraph;
  TreeParameters Parameters;
  std::vector<std::pair<int, int>> Components;
  std::vector<FeatureCorrespondence> Leaves;
  TreeStatistics Statistics;
};
}

#endif
