// SPDX-License-Identifier: BSD-3-Clause
#include "SpreadRounds.h"

#include <utility>

namespace marrow
{
namespace
{
/// After the first, in which the sources alone are heard; more change nothing.
constexpr int NumberOfRounds = 2;
constexpr double Sharpening = 1.5;
}

std::vector<LabelShares> SpreadInRounds(const CollectionGraph& graph,
  const std::function<ShareLink(const Teller&)>& mapOf,
  const std::function<const TriangleMesh&(int)>& meshOf, std::vector<LabelShares>& ofTriangles)
{
  std::vector<LabelShares> ofVertices(graph.NumberOfShapes());
  for (int round = 0; round <= NumberOfRounds; ++round)
  {
    for (int s = 0; s < graph.NumberOfShapes(); ++s)
    {
      if (graph.IsSource(s))
      {
        continue;
      }
      std::vector<ShareLink> links;
      for (const Teller& teller : graph.GetTellers(s))
      {
        if (ofTriangles[teller.Shape].size() > 0)
        {
          ShareLink link = mapOf(teller);
          link.OfTriangles = &ofTriangles[teller.Shape];
          link.Weight = graph.WeightOf(teller);
          links.push_back(link);
        }
      }
      ofVertices[s] = GatherShares(links, meshOf(s).NumberOfVertices(), graph.NumberOfLabels());
      SharpenShares(ofVertices[s], round < NumberOfRounds ? Sharpening : 1.0);
    }
    // Only now, so that the order of the shapes decides nothing.
    for (int s = 0; s < graph.NumberOfShapes(); ++s)
    {
      if (!graph.IsSource(s))
      {
        ofTriangles[s] = SharesOfTriangles(meshOf(s), ofVertices[s]);
      }
    }
  }
  return ofVertices;
}
}
