// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonMap_h
#define marrow_SkeletonMap_h

#include "AnalyzedMesh.h"
#include "ChainAlignment.h"
#include "MatchedSkeletons.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// How the space round the target's skeleton lies to that round the source's.
///
/// For every matched chain it gives the rotation that carries directions, found as in the transfer
/// paper (T:4.2): shape matching of the matched branch vectors at the junctions, then the chain's own
/// direction aligned. The paper keeps the junction's frame all along the branch; here it is carried
/// along both chains without twist, so that a bent limb's frame bends with it, and where both ends
/// are junctions the two results are blended.
class SkeletonMap
{
public:
  /// `alignments`: per pair of chains which of its places correspond.
  SkeletonMap(const AnalyzedMesh& source, const AnalyzedMesh& target, const MatchedSkeletons& match,
    std::vector<ChainAlignment> alignments);

  double TargetRatio(int chain, double sourceRatio) const
  {
    return this->Alignments[chain].TargetRatio(sourceRatio);
  }
  double SourceRatio(int chain, double targetRatio) const
  {
    return this->Alignments[chain].SourceRatio(targetRatio);
  }

  /// Turns target directions into source directions.
  Eigen::Matrix3d Rotation(int chain, double sourceRatio) const;
  /// Source radius over target radius there.
  double RadialScale(int chain, double sourceRatio) const;
  /// The rotation that fits the matched skeletons as wholes.
  const Eigen::Matrix3d& GlobalRotation() const { return this->Global; }

  /// Where a target node lies on the source.
  struct Place
  {
    bool Known = false;   ///< false: its component has nothing matched
    bool Matched = false; ///< false: it hangs on the place where its branch leaves the matched part
    bool IsLeftover = false; ///< not matched, but found where it lies: see PlaceLeftovers
    int SourceNode = -1;     ///< nearest node of the source
    double Radius = 0.0;     ///< source radius there
    Eigen::Matrix<double, 3, 4> Transform =
      Eigen::Matrix<double, 3, 4>::Zero(); ///< target to source
  };
  /// One place per target node.
  std::vector<Place> PlacesOfTargetNodes() const;
  /// Whether a source node lies on a matched chain or is a matched node.
  std::vector<bool> MatchedSourceNodes() const;

private:
  void ComputeGlobalRotation();
  void ComputeChainFrames(int chain);
  Eigen::Matrix3d EndRotation(int chain, bool back, int& numberOfVectors) const;
  Place PlaceOnChain(int chain, double targetRatio) const;
  Place PlaceOfEnds(int targetNode) const;

  /// Of the frames of a chain; between them they are blended.
  static constexpr int NumberOfSamples = 33;
  struct ChainFrames
  {
    std::vector<Eigen::Matrix3d> Rotations;
    std::vector<double> Scales;
  };

  const AnalyzedMesh& Source;
  const AnalyzedMesh& Target;
  const MatchedSkeletons& Match;
  Eigen::Matrix3d Global = Eigen::Matrix3d::Identity();
  std::vector<ChainFrames> Frames;
  std::vector<ChainAlignment> Alignments;
};
}

#endif
