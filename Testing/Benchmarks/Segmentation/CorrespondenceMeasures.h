// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CorrespondenceMeasures_h
#define marrow_CorrespondenceMeasures_h

#include "FeaturePoints.h"
#include "PreparedMesh.h"
#include "ResultTable.h"

namespace marrow::bench
{
/// One side of a correspondence.
struct MatchedSide
{
  const PreparedMesh& Mesh;
  const TerminalFeatures& Features;
  std::vector<int> CorrespondenceOfNode; ///< -1 for none
};

/// Adds to `result`, as counts:
/// - matched_pairs, same_label_pairs: matched groups of nodes, and those with one semantic label
///   (majority over φ);
/// - matched_terminals, same_label_terminals: those of them that are terminals on both sides;
/// - judged_pairs, consistent_pairs, left_right_flips, front_back_flips: matched terminals with
///   feature points on both sides; those that share one; of the rest, those where one side has the
///   mirror image of the other's, and those that carry the same semantic label (a front leg matched
///   with a hind leg);
/// - feature_nodes, matched_feature_nodes: terminals and junctions of both skeletons.
void MeasureCorrespondence(const MatchedSide& source, const MatchedSide& target,
  const std::vector<int>& mirrorFeatures, Result& result);
}

#endif
