// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentCut_h
#define marrow_SegmentCut_h

#include "PolygonMesh.h"
#include "Progress.h"

#include <array>
#include <vector>

namespace marrow
{
/// A surface cut along the boundaries of its segments.
struct SegmentCut
{
  /// A point where a boundary meets an edge, or where three segments meet inside a triangle: a weighted
  /// mean of points of the input.
  struct NewPoint
  {
    std::array<int, 3> Points = { -1, -1, -1 };
    std::array<double, 3> Weights = { 0.0, 0.0, 0.0 };
    int Size = 0;
  };
  /// They follow the points of the input, whose numbers stay.
  std::vector<NewPoint> NewPoints;

  /// The pieces in the order of the polygons that they are of. Piece i has the corners Offsets[i] to
  /// Offsets[i + 1] - 1.
  std::vector<int> Offsets = { 0 };
  std::vector<int> Corners;
  std::vector<int> PolygonOfPiece;
  std::vector<int> LabelOfPiece;
};

/// Cuts the polygons that a boundary crosses, so that boundaries are smooth lines instead of the edges
/// that happen to lie near them.
///
/// Each vertex has shares of the segments, by the area of its polygons, which are then smoothed a few
/// times over the edges near boundaries; a boundary runs where two shares are equal, linearly
/// interpolated along the edges (marching triangles for several labels). It stays within some two
/// faces of where the labels change. All other polygons pass as they are, and where two faces share an edge
/// they are cut at the same point. Points at the same place are taken for one. A segment too small to be
/// the most of any vertex keeps its faces. Nothing is to be used if `progress` asked to stop.
SegmentCut CutAlongSegments(
  const PolygonMesh& mesh, const std::vector<int>& labelOfPolygon, const Progress& progress = {});
}

#endif
