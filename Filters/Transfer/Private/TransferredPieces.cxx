// SPDX-License-Identifier: BSD-3-Clause
#include "TransferredPieces.h"

#include <algorithm>
#include <map>

namespace marrow
{
std::vector<bool> TransferredPieces(
  const AnalyzedMesh& source, const SegmentPieces& pieces, const std::vector<bool>& isNodeMatched)
{
  std::vector<std::map<int, double>> areaInPieces(isNodeMatched.size());
  std::vector<double> matched(pieces.NumberOfPieces(), 0.0);
  for (int t = 0; t < source.Mesh.NumberOfTriangles(); ++t)
  {
    const double third = source.Mesh.Area(t) / 3.0;
    for (int corner : source.Mesh.Triangles[t])
    {
      const int node = source.NodeOfVertex[corner];
      if (node >= 0 && isNodeMatched[node])
      {
        areaInPieces[node][pieces.PieceOfTriangle[t]] += third;
        matched[pieces.PieceOfTriangle[t]] += third;
      }
    }
  }
  std::vector<bool> result(pieces.NumberOfPieces());
  for (int p = 0; p < pieces.NumberOfPieces(); ++p)
  {
    result[p] = matched[p] >= 0.5 * pieces.AreaOfPiece[p];
  }
  for (const auto& shares : areaInPieces)
  {
    if (!shares.empty())
    {
      const auto most = std::max_element(shares.begin(), shares.end(),
        [](const auto& x, const auto& y) { return x.second < y.second; });
      result[most->first] = true;
    }
  }
  // If no piece qualifies there is nothing better than to try them all.
  return std::count(result.begin(), result.end(), true) > 0
    ? result
    : std::vector<bool>(pieces.NumberOfPieces(), true);
}
}
