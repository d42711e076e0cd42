// SPDX-License-Identifier: BSD-3-Clause
#include "LabelCleanUp.h"

#include "SegmentLoops.h"

#include <algorithm>
#include <map>

namespace marrow
{
void KeepLargestComponents(const TriangleMesh& mesh, std::vector<int>& pieceOfTriangle)
{
  // Components of equal piece are "pieces" of a segmentation by pieces.
  const SegmentPieces components = FindPieces(mesh, pieceOfTriangle);
  const int n = components.NumberOfPieces();
  std::map<int, int> largest;
  for (int c = 0; c < n; ++c)
  {
    const auto [entry, isNew] = largest.insert({ components.LabelOfPiece[c], c });
    if (!isNew && components.AreaOfPiece[c] > components.AreaOfPiece[entry->second])
    {
      entry->second = c;
    }
  }
  std::vector<std::map<int, double>> borders(n);
  for (int h = 0; h < 3 * mesh.NumberOfTriangles(); ++h)
  {
    const int opposite = mesh.Opposite[h];
    if (opposite < 0)
    {
      continue;
    }
    const int a = components.PieceOfTriangle[TriangleMesh::TriangleOf(h)];
    const int b = components.PieceOfTriangle[TriangleMesh::TriangleOf(opposite)];
    if (a != b)
    {
      borders[a][b] += (mesh.Points[mesh.From(h)] - mesh.Points[mesh.To(h)]).norm();
    }
  }
  std::vector<int> result(n, -1);
  for (const auto& [piece, component] : largest)
  {
    result[component] = piece;
  }
  // Islands join kept regions, the largest first; an island among islands waits for its neighbours.
  std::vector<int> islands;
  for (int c = 0; c < n; ++c)
  {
    if (result[c] < 0)
    {
      islands.push_back(c);
    }
  }
  std::stable_sort(islands.begin(), islands.end(),
    [&](int a, int b) { return components.AreaOfPiece[a] > components.AreaOfPiece[b]; });
  for (bool changed = true; changed;)
  {
    changed = false;
    for (int c : islands)
    {
      if (result[c] >= 0)
      {
        continue;
      }
      std::map<int, double> lengths;
      for (const auto& [other, length] : borders[c])
      {
        if (result[other] >= 0)
        {
          lengths[result[other]] += length;
        }
      }
      if (!lengths.empty())
      {
        result[c] = std::max_element(lengths.begin(), lengths.end(),
          [](const auto& a, const auto& b) {
            return a.second < b.second;
          })->first;
        changed = true;
      }
    }
  }
  for (std::size_t t = 0; t < pieceOfTriangle.size(); ++t)
  {
    const int kept = result[components.PieceOfTriangle[t]];
    // A component of the mesh that consists of islands alone stays what it is.
    pieceOfTriangle[t] = kept >= 0 ? kept : pieceOfTriangle[t];
  }
}
}
