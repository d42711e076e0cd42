// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PairMeasures_h
#define marrow_PairMeasures_h

#include "FeaturePoints.h"
#include "Method.h"
#include "PreparedMesh.h"
#include "ResultTable.h"

namespace marrow::bench
{
/// A category's meshes, and what was found out about their feature points.
struct PreparedCategory
{
  std::vector<PreparedMesh> Meshes;
  std::vector<TerminalFeatures> Features;
  std::vector<int> MirrorFeatures;
};

/// The columns of a pair.
const std::vector<std::string>& PairColumns();

/// Matches two meshes, transfers the pieces of the one to the other if `transfer` is on, and measures
/// everything. `segments` receives the target's segments. An error of a filter goes into the result.
/// Safe on several threads at once.
Result MeasurePair(const PreparedCategory& category, int source, int target, MatcherKind matcher,
  bool transfer, std::vector<int>& segments);
}

#endif
