// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SpreadRounds_h
#define marrow_SpreadRounds_h

#include "CollectionGraph.h"
#include "LabelShares.h"
#include "TriangleMesh.h"

#include <functional>
#include <vector>

namespace marrow
{
/// Lets labels spread over a graph: first every shape hears its sources, then, twice, all of its tellers.
/// After each round the shares are raised to the power of 1.5, so that what a few wrong maps bring fades.
/// `mapOf` says where a told shape's vertices lie on a teller, `meshOf` which mesh of a shape, fine or
/// coarse, these are of. `ofTriangles` are the shares of the sources' triangles, and come to be all shapes';
/// returns those of the vertices, empty for the sources, not sharpened in the last round.
std::vector<LabelShares> SpreadInRounds(const CollectionGraph& graph,
  const std::function<ShareLink(const Teller&)>& mapOf,
  const std::function<const TriangleMesh&(int)>& meshOf, std::vector<LabelShares>& ofTriangles);
}

#endif
