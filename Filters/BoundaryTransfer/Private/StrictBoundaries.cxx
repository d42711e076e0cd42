// SPDX-License-Identifier: BSD-3-Clause
#include "StrictBoundaries.h"

#include "EnclosedBranch.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace marrow
{
std::vector<CarriedLoop> CarryLoops(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, const SkeletonMap& map,
  const BoundaryTransfer::Parameters& parameters, const std::vector<SegmentLoop>& loops,
  const std::vector<bool>& isTransferred, const Progress& progress)
{
  std::vector<CarriedLoop> carried;
  BoundaryTransfer transfer(source, target, match, map, parameters);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (!Report(progress, static_cast<double>(i) / loops.size()))
    {
      break;
    }
    const auto seat = isTransferred[loops[i].LeftPiece] && isTransferred[loops[i].RightPiece]
      ? FindSeat(source, match, loops[i])
      : std::nullopt;
    auto cut = seat ? transfer.Transfer(loops[i], *seat, map.TargetRatio(seat->Chain, seat->Ratio))
                    : std::nullopt;
    if (cut)
    {
      carried.push_back({ static_cast<int>(i), std::move(*cut) });
    }
  }
  return carried;
}

SegmentPieces MergePieces(const SegmentPieces& pieces, const std::vector<SegmentLoop>& loops,
  const std::vector<CarriedLoop>& carried)
{
  std::set<int> isCarried;
  for (const CarriedLoop& loop : carried)
  {
    isCarried.insert(loop.Loop);
  }
  const int n = pieces.NumberOfPieces();
  std::vector<int> rank(n, 0);
  std::vector<int> parent(n);
  boost::disjoint_sets<int*, int*> unions(rank.data(), parent.data());
  for (int piece = 0; piece < n; ++piece)
  {
    unions.make_set(piece);
  }
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (isCarried.count(static_cast<int>(i)) == 0)
    {
      unions.union_set(loops[i].LeftPiece, loops[i].RightPiece);
    }
  }
  SegmentPieces merged;
  std::map<int, int> unionOfRoot;
  std::vector<int> unionOfPiece(n);
  std::vector<double> largest;
  for (int piece = 0; piece < n; ++piece)
  {
    const auto [entry, isNew] =
      unionOfRoot.insert({ unions.find_set(piece), merged.NumberOfPieces() });
    if (isNew)
    {
      merged.LabelOfPiece.push_back(0);
      merged.AreaOfPiece.push_back(0.0);
      largest.push_back(-1.0);
    }
    const int u = unionOfPiece[piece] = entry->second;
    merged.AreaOfPiece[u] += pieces.AreaOfPiece[piece];
    if (pieces.AreaOfPiece[piece] > largest[u])
    {
      largest[u] = pieces.AreaOfPiece[piece];
      merged.LabelOfPiece[u] = pieces.LabelOfPiece[piece];
    }
  }
  for (const int piece : pieces.PieceOfTriangle)
  {
    merged.PieceOfTriangle.push_back(unionOfPiece[piece]);
  }
  return merged;
}

std::vector<std::vector<int>> PiecesBeyondCurves(const TriangleMesh& source,
  const SegmentPieces& pieces, const std::vector<SegmentLoop>& loops,
  const std::vector<CarriedLoop>& carried, int numberOfTargetTriangles)
{
  std::vector<std::vector<int>> beyond(numberOfTargetTriangles);
  for (const CarriedLoop& loop : carried)
  {
    // Pieces lie on one side of a loop as a whole, or on both if they are one beyond its ends; a loop
    // round a handle has sides only near by.
    std::set<int> left;
    std::set<int> right;
    std::vector<char> isLeft;
    const bool separates = SidesOfLoop(source, loops[loop.Loop].HalfEdges, isLeft);
    if (separates)
    {
      for (std::size_t t = 0; t < isLeft.size(); ++t)
      {
        (isLeft[t] == 1 ? left : right).insert(pieces.PieceOfTriangle[t]);
      }
    }
    else
    {
      const int h = loops[loop.Loop].HalfEdges.front();
      left.insert(pieces.PieceOfTriangle[TriangleMesh::TriangleOf(h)]);
      right.insert(pieces.PieceOfTriangle[TriangleMesh::TriangleOf(source.Opposite[h])]);
    }
    std::vector<int> onlyLeft;
    std::vector<int> onlyRight;
    std::set_difference(
      left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(onlyLeft));
    std::set_difference(
      right.begin(), right.end(), left.begin(), left.end(), std::back_inserter(onlyRight));
    for (const auto& [triangle, side] : loop.Cut.Sides)
    {
      const std::vector<int>& other = (side == 0) == loop.Cut.LeftIsFront ? onlyRight : onlyLeft;
      beyond[triangle].insert(beyond[triangle].end(), other.begin(), other.end());
    }
  }
  return beyond;
}
}
