// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SideTransfer_h
#define marrow_SideTransfer_h

#include "AnalyzedSide.h"
#include "Hints.h"
#include "SegmentationTransfer.h"

#include <set>
#include <string>
#include <vector>

namespace marrow
{
/// Which body of the source a body of the target takes its segments from, and how they may match.
struct Partner
{
  std::size_t SourceBody = 0;
  std::vector<Answer> Answers; ///< the cheapest first
};

/// A hint about one body of the target.
struct BodyHint
{
  std::size_t SourceBody = 0;
  SurfaceHint Hint; ///< in the vertices of the two bodies
};

/// The body of the source that matches `target` at the least cost; where hints say which bodies correspond,
/// one of these. What `progress` stops is left unfinished.
Partner FindPartner(const AnalyzedSide& source, const AnalyzedMesh& target,
  const std::vector<BodyHint>& hints, const Progress& progress);

/// Labels in the terms of the input.
struct CellLabels
{
  std::vector<int> Labels;        ///< per cell; -1 for vertices and lines, which are no surface
  std::vector<double> Confidence; ///< per cell, [0,1]
};

/// From the triangles of the working surface to the cells of the input.
CellLabels ToCells(const PreparedSurface& surface, const std::vector<int>& labelOfTriangle,
  const std::vector<double>& confidenceOfTriangle);

/// What the user says about a transfer, in the terms of the input.
struct SideGuidance
{
  std::vector<PointHint> Hints;
  int AnswerIndex = 0;         ///< of the answers for each body, the likeliest first
  std::vector<int> KeptLabels; ///< per cell of the target, NoLabel for none; empty: none is kept
};

/// What came over to all bodies of the target, in the terms of the input.
struct SideTransferResult
{
  std::vector<int> Labels;              ///< per cell of the target
  std::vector<double> Confidence;       ///< per cell of the target, [0,1]
  std::vector<BoundaryPair> Boundaries; ///< in the coordinates of the two meshes
  std::set<int> MissingLabels;          ///< labels that some body of the target has not got
  int NumberOfMissingPieces = 0;        ///< of the body that misses most
  /// Of the matching, the mean over the area; 1 where nothing is matched.
  double Cost = 0.0;
  double Evidence = 0.0;              ///< what the surfaces say against the matching, likewise
  double AnswerConfidence = 0.0;      ///< in the matching, likewise; [0,1]
  bool IsMatched = true;              ///< skeletons or slices have an answer for every body
  bool IsWholeAlignment = false;      ///< some body is aligned as a whole
  std::vector<std::string> MatchedBy; ///< per body "skeletons", "slices" or "whole"
  int NumberOfUnmetHints = 0;
  std::string Error; ///< one sentence on a guidance that cannot be followed, or empty
};

/// Each body of the target takes its segments from the body of the source that matches it at the least
/// cost; where the skeletons bring their correspondence, both are one body, and that is used. What
/// `progress` stops is left unfinished.
SideTransferResult TransferSide(const AnalyzedSide& source, const AnalyzedSide& target,
  const GivenCorrespondence& givenSource, const GivenCorrespondence& givenTarget,
  const std::vector<std::vector<int>>& labelsOfSourceBodies, const TransferParameters& parameters,
  const SideGuidance& guidance, const Progress& progress);
}

#endif
