// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TerminalPaths_h
#define marrow_TerminalPaths_h

#include "FeatureGraph.h"

#include <cstdint>
#include <vector>

namespace marrow
{
/// The terminals of a skeleton and the paths between them: what a comparison over the whole skeletons
/// looks at, since it does not change with pose and hardly with spurs and split junctions. Of loops,
/// only what is in the graph's forest is seen.
class TerminalPaths
{
public:
  /// A set of terminals, one bit each.
  using Mask = std::uint64_t;
  /// The heaviest terminals are taken if there are more.
  static constexpr int MaximumTerminals = 48;

  struct Path
  {
    bool Exists = false;         ///< false between components
    std::vector<int> Darts;      ///< from the one terminal to the other
    double Length = 0.0;         ///< over the weighted mean length of all paths
    std::vector<double> Profile; ///< square root of MSP in equal pieces
    std::vector<double> Chords;  ///< straightness of the middle parts, in [0,1]
    double Likeness = 0.0; ///< of the two terminals, in [0,1]: twins like the two hands are near 1
    double Angle = 0.0;    ///< between the directions of the two terminal branches, over π
  };
  /// A branch whose removal splits the terminals in two sets of at least two each.
  struct Split
  {
    int Branch = -1;
    Mask Beyond = 0; ///< the terminals on the side of the branch's back
    double Cost =
      0.0; ///< of contracting it: its length, but little while that is within the junctions
  };

  explicit TerminalPaths(const FeatureGraph& graph);

  int Size() const { return static_cast<int>(this->Features.size()); }
  int Feature(int terminal) const { return this->Features[terminal]; }
  /// The terminal at a feature; -1 if there is none.
  int TerminalAt(int feature) const { return this->TerminalOfFeature[feature]; }
  /// The terminal's importance: its branch's share in length and surface; the sum is 1.
  double Weight(int terminal) const { return this->Weights[terminal]; }
  const Path& Between(int from, int to) const { return this->Paths[from * this->Size() + to]; }
  const std::vector<Split>& GetSplits() const { return this->Splits; }
  /// The square root of MSP at growing distances from the tip, on the way to the most central feature.
  const std::vector<double>& Taper(int terminal) const { return this->Tapers[terminal]; }
  /// Points of the terminal's branch, from the tip to the root, as many for every terminal.
  const std::vector<Eigen::Vector3d>& Points(int terminal) const { return this->Samples[terminal]; }
  const FeatureGraph& Graph() const { return this->Skeleton; }

  /// The terminals on the far side of a dart.
  Mask Beyond(int dart) const;

private:
  void ChooseTerminals();
  void FindPaths();
  void FindTapers(double scale);
  void FindTwins();
  void FindSplits();

  const FeatureGraph& Skeleton;
  std::vector<int> Features;
  std::vector<int> TerminalOfFeature;
  std::vector<double> Weights;
  std::vector<Path> Paths;
  std::vector<Split> Splits;
  std::vector<std::vector<double>> Tapers;
  std::vector<std::vector<Eigen::Vector3d>> Samples;
};
}

#endif
