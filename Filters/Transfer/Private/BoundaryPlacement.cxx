// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryPlacement.h"

#include "EnclosedBranch.h"

namespace marrow
{
double Disagreement(const AnalyzedMesh& source, const AnalyzedMesh& target, const SegmentLoop& loop,
  const BoundaryTransfer::Cut& cut, const SegmentPieces& pieces, const GuidedMap& map)
{
  std::vector<char> sides;
  if (!SidesOfLoop(source.Mesh, loop.HalfEdges, sides))
  {
    return 0.0;
  }
  // A piece is on one side of the loop as a whole: the loop runs between pieces.
  std::vector<char> isFront(pieces.NumberOfPieces(), 0);
  for (std::size_t t = 0; t < sides.size(); ++t)
  {
    isFront[pieces.PieceOfTriangle[t]] = (sides[t] == 1) == cut.LeftIsFront;
  }
  double wrong = 0.0;
  double total = 0.0;
  for (const auto& [triangle, side] : cut.Sides)
  {
    double front = 0.0;
    for (int corner : target.Mesh.Triangles[triangle])
    {
      for (int piece = 0; piece < pieces.NumberOfPieces(); ++piece)
      {
        front += isFront[piece] ? map.Shares(corner, piece) / 3.0 : 0.0;
      }
    }
    const double area = target.Mesh.Area(triangle);
    wrong += (front > 0.5) == (side == 0) ? 0.0 : area;
    total += area;
  }
  return total > 0.0 ? wrong / total : 1.0;
}
}
