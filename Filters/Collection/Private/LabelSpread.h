// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelSpread_h
#define marrow_LabelSpread_h

#include "CollectionGraph.h"
#include "LabelShares.h"
#include "Progress.h"

#include <vector>

namespace marrow
{
/// What a shape without labels got.
struct SpreadLabels
{
  std::vector<int> Labels; ///< per triangle
  /// Per triangle, [0,1]: the share of its label, if one more teller, of the sort against which all is to
  /// be said, told something else.
  std::vector<double> Confidence;
  /// Of its tellers the source that counts most, -1 if none of them is one, and what speaks against the
  /// answer that is taken of it.
  int Source = -1;
  double Against = 1.0;
  bool IsWholeAlignment = false; ///< with that source
};

/// Leaves each shape of a graph the tellers that it hears at the working resolution: all sources, and the
/// others that count most.
void ChooseTellers(CollectionGraph& graph);

/// Carries out the maps of all tellers, as far as that was not done before. False if `progress` asked to stop.
bool CarryMaps(CollectionGraph& graph, const Progress& progress);

/// Lets the labels spread at the working resolution: per shape the shares of its vertices, empty for the
/// sources.
std::vector<LabelShares> SpreadShares(const CollectionGraph& graph);

/// Settles the labels of each shape by one cut of the shares of its vertices. Per shape; nothing for the
/// sources. What `progress` stops is left unfinished.
std::vector<SpreadLabels> LabelShapes(const CollectionGraph& graph,
  const std::vector<LabelShares>& ofVertices, const Progress& progress);
}

#endif
