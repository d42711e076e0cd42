// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentLoops_h
#define marrow_SegmentLoops_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The connected pieces of a segmentation: a segment "leg" may have four.
struct SegmentPieces
{
  std::vector<int> PieceOfTriangle;
  std::vector<int> LabelOfPiece;
  std::vector<double> AreaOfPiece;

  int NumberOfPieces() const { return static_cast<int>(this->LabelOfPiece.size()); }
};

/// Pieces are numbered in the order of their first triangle.
SegmentPieces FindPieces(const TriangleMesh& mesh, const std::vector<int>& labels);

/// A closed boundary of a piece.
struct SegmentLoop
{
  /// The half-edges of the piece's triangles along the boundary, in order: the piece lies on their
  /// left.
  std::vector<int> HalfEdges;
  int LeftPiece = -1;
  int RightPiece =
    -1; ///< of several neighbours (three-way junctions) the one along most of the loop

  std::vector<int> Vertices(const TriangleMesh& mesh) const;
};

/// The closed boundaries between pieces, each once. A loop with one neighbour is shared by two
/// pieces. Where three pieces meet, a piece's own border loop counts, smallest piece first (a limb's
/// ring rather than what is left of the torso round it), unless most of its edges belong to loops
/// found before. Loops that run along the mesh's border are left out.
std::vector<SegmentLoop> FindLoops(const TriangleMesh& mesh, const SegmentPieces& pieces);
}

#endif
