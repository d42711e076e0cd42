// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CoarseShares_h
#define marrow_CoarseShares_h

#include "CollectionGraph.h"
#include "LabelShares.h"

#include <vector>

namespace marrow
{
/// The shares of the coarse triangles of a shape whose triangles are labelled.
LabelShares CoarseSharesOfLabels(const CollectionShape& shape, const std::vector<int>& labels,
  const std::vector<int>& differentLabels);

/// What a teller brings to the coarse vertices of the shape that it tells, by one of the answers of their
/// pair. `ofTriangles` are the shares of the teller's coarse triangles.
LabelShares TellCoarsely(const CollectionGraph& graph, const LabelShares& ofTriangles,
  const Teller& teller, std::size_t answer, double weight);
}

#endif
