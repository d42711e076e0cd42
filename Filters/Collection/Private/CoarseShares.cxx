// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseShares.h"

namespace marrow
{
LabelShares CoarseSharesOfLabels(const CollectionShape& shape, const std::vector<int>& labels,
  const std::vector<int>& differentLabels)
{
  return SharesOfTriangles(shape.Coarse.Side.Mesh,
    SharesOfCells(shape.Fine.Mesh, shape.Coarse, SharesOfLabels(labels, differentLabels)));
}

LabelShares TellCoarsely(const CollectionGraph& graph, const LabelShares& ofTriangles,
  const Teller& teller, std::size_t answer, double weight)
{
  const CollectionLink& link = graph.GetLinks()[teller.Link];
  const TriedAnswer& tried = link.Pair->GetAnswers()[answer];
  return GatherShares({ { &ofTriangles, &tried.FoundTriangles[teller.Side], nullptr, weight } },
    graph.GetShape(link.Shapes[teller.Side]).Coarse.Side.Mesh.NumberOfVertices(),
    graph.NumberOfLabels());
}
}
