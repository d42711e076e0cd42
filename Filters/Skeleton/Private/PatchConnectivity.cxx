// SPDX-License-Identifier: BSD-3-Clause
#include "PatchConnectivity.h"

#include <algorithm>
#include <map>

namespace marrow
{
namespace
{
struct Piece
{
  int Patch;
  std::vector<int> Vertices;
};

std::vector<Piece> FindPieces(const TriangleMesh& mesh, const std::vector<int>& patchOfVertex)
{
  std::vector<Piece> pieces;
  std::vector<char> seen(patchOfVertex.size(), 0);
  for (int seed = 0; seed < mesh.NumberOfVertices(); ++seed)
  {
    if (seen[seed] || patchOfVertex[seed] < 0)
    {
      continue;
    }
    Piece piece{ patchOfVertex[seed], { seed } };
    seen[seed] = 1;
    for (std::size_t head = 0; head < piece.Vertices.size(); ++head)
    {
      mesh.ForEachNeighbor(piece.Vertices[head],
        [&](int neighbor)
        {
          if (!seen[neighbor] && patchOfVertex[neighbor] == piece.Patch)
          {
            seen[neighbor] = 1;
            piece.Vertices.push_back(neighbor);
          }
        });
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}
}

void JoinStrayPieces(const TriangleMesh& mesh, std::vector<int>& patchOfVertex)
{
  // A stray piece may border on stray pieces that move in the same round: a few rounds settle it.
  constexpr int MaximumRounds = 10;
  for (int round = 0; round < MaximumRounds; ++round)
  {
    std::vector<Piece> pieces = FindPieces(mesh, patchOfVertex);
    std::stable_sort(pieces.begin(), pieces.end(),
      [](const Piece& a, const Piece& b) { return a.Vertices.size() > b.Vertices.size(); });
    std::map<int, int> piecesOfPatch;
    bool joined = false;
    for (const Piece& piece : pieces)
    {
      if (piecesOfPatch[piece.Patch]++ == 0)
      {
        continue;
      }
      std::map<int, int> borders;
      for (const int v : piece.Vertices)
      {
        mesh.ForEachNeighbor(v,
          [&](int neighbor)
          {
            const int other = patchOfVertex[neighbor];
            if (other >= 0 && other != piece.Patch)
            {
              ++borders[other];
            }
          });
      }
      if (borders.empty())
      {
        continue;
      }
      const int target = std::max_element(borders.begin(), borders.end(),
        [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first;
      for (const int v : piece.Vertices)
      {
        patchOfVertex[v] = target;
      }
      joined = true;
    }
    if (!joined)
    {
      return;
    }
  }
}
}
