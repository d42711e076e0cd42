// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentationTransfer_h
#define marrow_SegmentationTransfer_h

#include "AnalyzedMesh.h"
#include "AnswerChoice.h"
#include "Guidance.h"
#include "Progress.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// The transfer paper's way, boundaries around one branch and no others, and what can be set about it.
struct TransferParameters
{
  bool StrictBoundaries = false;
  double Theta = 1.5;         ///< how far a ghost boundary stands out
  double Kernel = 0.05;       ///< K, smoothing of profiles, of the chain's length
  double Lambda = 0.1;        ///< λ, tolerance of dihedral angles, radians
  double SearchRegion = 0.02; ///< of the snake, of the longest geodesic distance
};

/// A boundary of the source and, if it was transferred, of the target.
struct BoundaryPair
{
  int LeftLabel = 0;
  int RightLabel = 0;
  std::vector<Eigen::Vector3d> SourcePoints; ///< in order, not closed by a repeated point
  std::vector<Eigen::Vector3d> TargetPoints; ///< the corresponding ones; empty if not transferred
  bool EnclosesBranch = false;               ///< exactly one, and that is matched
};

/// A segmentation carried over.
struct TransferResult
{
  std::vector<int> Labels;        ///< per target triangle
  std::vector<double> Confidence; ///< per target triangle, [0,1]
  std::vector<BoundaryPair> Boundaries;
  std::vector<int> MissingLabels; ///< labels of the source that the target has not got, ascending
  int NumberOfMissingPieces = 0;  ///< pieces of the source without a place on the target
  std::size_t Answer = 0;         ///< which answer was taken
  double Evidence = 0.0;          ///< what the surfaces say against it
  double AnswerConfidence = 0.0;  ///< [0,1], in it
  int NumberOfUnmetHints = 0;     ///< that the answer does not keep to
  bool IsAborted = false;
};

/// More connected pieces than this are noise, not segments; time and memory grow with their number.
inline constexpr int MostPieces = 500;

/// Carries the labels of the source's triangles to the target's, by the one of `answers` (at least
/// one, the cheapest first) that the surfaces support best, or the one that `guidance` wants of the order
/// of their likelihood; its AnswerIndex must be one of theirs.
TransferResult TransferSegmentation(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<Answer>& answers, const std::vector<int>& labels,
  const TransferParameters& parameters, const Guidance& guidance, const Progress& progress);
}

#endif
