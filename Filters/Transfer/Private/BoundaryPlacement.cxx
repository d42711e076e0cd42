// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryPlacement.h"

#include "EnclosedBranch.h"

namespace marrow
{
double Disagreement(const AnalyzedMesh& source, const AnalyzedMesh& target, const SegmentLoop& loop,
  const BoundaryTransfer::Cut& cut, const SegmentPieces& pieces, const GuidedMap& map)
{
  // A piece is on one side of the loop as a whole, since the loop runs between pieces; but a loop
  // round a handle has two sides only near by, and parts no more than the two pieces that meet there.
  enum Side : char
  {
    Front,
    Back,
    Neither
  };
  std::vector<Side> sideOf(pieces.NumberOfPieces(), Neither);
  std::vector<char> isLeft;
  if (SidesOfLoop(source.Mesh, loop.HalfEdges, isLeft))
  {
    for (std::size_t t = 0; t < isLeft.size(); ++t)
    {
      sideOf[pieces.PieceOfTriangle[t]] = (isLeft[t] == 1) == cut.LeftIsFront ? Front : Back;
    }
  }
  else
  {
    sideOf[loop.LeftPiece] = cut.LeftIsFront ? Front : Back;
    sideOf[loop.RightPiece] = cut.LeftIsFront ? Back : Front;
  }
  double wrong = 0.0;
  double total = 0.0;
  for (const auto& [triangle, side] : cut.Sides)
  {
    double shares[3] = { 0.0, 0.0, 0.0 };
    for (int corner : target.Mesh.Triangles[triangle])
    {
      for (int piece = 0; piece < pieces.NumberOfPieces(); ++piece)
      {
        shares[sideOf[piece]] += map.Shares(corner, piece);
      }
    }
    const double area = target.Mesh.Area(triangle);
    wrong += (shares[Front] > shares[Back]) == (side == 0) ? 0.0 : area;
    total += area;
  }
  return total > 0.0 ? wrong / total : 1.0;
}
}
