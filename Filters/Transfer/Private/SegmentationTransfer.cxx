// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentationTransfer.h"

#include "AnswerPlaces.h"
#include "BoundaryPairs.h"
#include "BoundaryTransfer.h"
#include "DenseMap.h"
#include "EdgePrices.h"
#include "FaceLabels.h"
#include "LabelCleanUp.h"
#include "LeftoverPlaces.h"
#include "MeshSmoother.h"
#include "SegmentLoops.h"
#include "SkeletonMap.h"
#include "StrictBoundaries.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace marrow
{
namespace
{
/// The width over which segments blend at their boundaries and concavity is measured, of the
/// diagonal: as far as the map may be wrong along the surface, so that between equal shapes boundaries
/// stay as they are, and between different ones the target's own shape decides where they run.
/// Anything from 1 to 2 times the standoff does.
double WidthFor(const DenseMap& map)
{
  constexpr double perStandoff =
    1.5;                         // 1 to 2 gave the same on four meshes of six categories, 3 less
  constexpr double least = 1e-4; // far below a face
  constexpr double most = 0.03;  // a segment's width: more would blend small ones away
  return std::clamp(perStandoff * map.Standoff, least, most);
}

/// Pieces that lie for the most part on matched branches, or hold a part of what is matched: a matched
/// node whose φ lies for the most part in them. (A patch on a limb holds no node; a body is one even
/// if most of its surface belongs to a branch of its own that has no partner.)
std::vector<bool> TransferredPieces(const AnalyzedMesh& source, const SegmentPieces& pieces,
  const std::vector<bool>& isMatched, bool anyMatched)
{
  if (!anyMatched)
  {
    return std::vector<bool>(pieces.NumberOfPieces(), true);
  }
  std::vector<std::map<int, double>> areaInPieces(isMatched.size());
  std::vector<double> matched(pieces.NumberOfPieces(), 0.0);
  for (int t = 0; t < source.Mesh.NumberOfTriangles(); ++t)
  {
    const double third = source.Mesh.Area(t) / 3.0;
    for (int corner : source.Mesh.Triangles[t])
    {
      const int node = source.NodeOfVertex[corner];
      if (node >= 0 && isMatched[node])
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

void SetConfidence(const AnalyzedMesh& target, const DenseMap& map, const Eigen::MatrixXd& shares,
  const SegmentPieces& pieces, TransferResult& result)
{
  result.Confidence.resize(result.Labels.size());
  for (std::size_t t = 0; t < result.Labels.size(); ++t)
  {
    double share = 0.0;
    for (int piece = 0; piece < pieces.NumberOfPieces(); ++piece)
    {
      if (pieces.LabelOfPiece[piece] == result.Labels[t])
      {
        share += ShareOfTriangle(target.Mesh, shares, static_cast<int>(t), piece);
      }
    }
    double certainty = 0.0;
    for (int corner : target.Mesh.Triangles[t])
    {
      certainty += map.Certainty[corner] / 3.0;
    }
    result.Confidence[t] = std::clamp(
      result.AnswerConfidence * (0.5 + 0.5 * certainty) * std::clamp(share, 0.0, 1.0), 0.0, 1.0);
  }
}

void SetMissing(int numberOfPieces, const std::vector<int>& sourceLabels,
  const std::vector<int>& pieceOfTriangle, TransferResult& result)
{
  const std::set<int> present(pieceOfTriangle.begin(), pieceOfTriangle.end());
  std::set<int> missing(sourceLabels.begin(), sourceLabels.end());
  for (const int label : result.Labels)
  {
    missing.erase(label);
  }
  result.MissingLabels.assign(missing.begin(), missing.end());
  result.NumberOfMissingPieces = numberOfPieces - static_cast<int>(present.size());
}

/// The paper's way: the loops that enclose one matched branch, each carried by the frames of that
/// branch.
std::vector<CarriedLoop> CarryLoops(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, const SkeletonMap& map, const TransferParameters& parameters,
  const std::vector<SegmentLoop>& loops, const std::vector<bool>& isTransferred,
  const Progress& progress)
{
  std::vector<CarriedLoop> carried;
  BoundaryTransfer transfer(
    source, target, match, map, { parameters.Lambda, parameters.SearchRegion });
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

/// Where a label is to be kept, no piece of another label may be; what the source has not got leaves the
/// choice open, as if nothing were known there.
void ExcludeAllButKept(const SegmentPieces& pieces, const std::vector<int>& keptLabels,
  std::vector<std::vector<int>>& excluded)
{
  if (keptLabels.empty())
  {
    return;
  }
  excluded.resize(keptLabels.size());
  for (std::size_t t = 0; t < keptLabels.size(); ++t)
  {
    const auto isKept = [&](int label) { return label == keptLabels[t]; };
    if (std::none_of(pieces.LabelOfPiece.begin(), pieces.LabelOfPiece.end(), isKept))
    {
      continue;
    }
    excluded[t].clear();
    for (int piece = 0; piece < pieces.NumberOfPieces(); ++piece)
    {
      if (!isKept(pieces.LabelOfPiece[piece]))
      {
        excluded[t].push_back(piece);
      }
    }
  }
}
}

TransferResult TransferSegmentation(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<Answer>& answers, const std::vector<int>& labels,
  const TransferParameters& parameters, const Guidance& guidance, const Progress& progress)
{
  TransferResult result;
  // Once told to stop, nobody is asked again.
  const Progress watched = [&](double fraction)
  {
    result.IsAborted = result.IsAborted || !Report(progress, fraction);
    return !result.IsAborted;
  };
  const bool isGiven = answers.front().IsGiven && !answers.front().IsEmpty();
  result.AnswerConfidence = answers.front().Confidence;
  // What the user gave is not judged.
  if (!isGiven)
  {
    const AnswerRanking ranking =
      RankAnswers(source, target, answers, guidance.Hints, SubProgress(watched, 0.0, 0.3));
    result.Answer = ranking.Order[guidance.AnswerIndex];
    result.Evidence = ranking.Surfaces[result.Answer];
    result.AnswerConfidence = ConfidenceOf(result.Evidence);
  }
  if (result.IsAborted)
  {
    return result;
  }
  const MatchedSkeletons& match = answers[result.Answer].Match;
  SegmentPieces pieces = FindPieces(source.Mesh, labels);
  const std::vector<SegmentLoop> loops = FindLoops(source.Mesh, pieces);
  result.Boundaries = PairsOfLoops(source, match, pieces, loops);
  SkeletonMap skeletonMap(source, target, match);
  AlignWithLandmarks(source, target, match, { parameters.Theta, parameters.Kernel }, skeletonMap);
  const bool anyMatched = !match.IsEmpty();
  std::vector<SkeletonMap::Place> places = skeletonMap.PlacesOfTargetNodes();
  std::vector<bool> isMatched = skeletonMap.MatchedSourceNodes();
  PlaceLeftovers(source, target, places, isMatched);
  std::vector<bool> isTransferred = TransferredPieces(source, pieces, isMatched, anyMatched);
  if (!watched(0.35))
  {
    return result;
  }

  std::vector<std::vector<int>> excluded;
  const int numberOfPieces = pieces.NumberOfPieces();
  if (parameters.StrictBoundaries)
  {
    const std::vector<CarriedLoop> carried = CarryLoops(source, target, match, skeletonMap,
      parameters, loops, isTransferred, SubProgress(watched, 0.35, 0.5));
    pieces = MergePieces(pieces, loops, carried);
    isTransferred = TransferredPieces(source, pieces, isMatched, anyMatched);
    excluded =
      PiecesBeyondCurves(source.Mesh, pieces, loops, carried, target.Mesh.NumberOfTriangles());
    for (const CarriedLoop& loop : carried)
    {
      result.Boundaries[loop.Loop].TargetPoints = loop.Cut.Curve.Points;
    }
  }
  if (result.IsAborted)
  {
    return result;
  }

  std::vector<bool> isFindable;
  for (const int piece : pieces.PieceOfTriangle)
  {
    isFindable.push_back(isTransferred[piece]);
  }
  DenseMapper mapper(source, target, isFindable, guidance.Hints);
  const Progress ofMap = SubProgress(watched, 0.5, 0.8);
  const auto& slices = answers[result.Answer].Slices;
  const DenseMap map = slices ? mapper.Map(*slices, ofMap) : mapper.Map(places, anyMatched, ofMap);
  if (!watched(0.8))
  {
    return result;
  }
  result.IsWholeAlignment = map.IsWholeAlignment;
  result.NumberOfUnmetHints = NumberOfUnmetHints(source, guidance.Hints, map.FoundTriangles);
  const double width = WidthFor(map);
  const MeshSmoother blend(target.Mesh, width * target.Diagonal());
  const Eigen::MatrixXd shares =
    blend.Smooth(mapper.Shares(map, pieces.PieceOfTriangle, pieces.NumberOfPieces()));
  ExcludeAllButKept(pieces, guidance.KeptLabels, excluded);
  std::vector<int> pieceOfTriangle = LabelFaces(target.Mesh, shares,
    EdgePrices(target.Mesh, EdgeConcavity(target.Mesh, blend),
      PreferenceOf(source.Mesh, pieces.PieceOfTriangle, width)),
    excluded, SubProgress(watched, 0.8, 0.95));
  if (!watched(0.95))
  {
    return result;
  }
  KeepLargestComponents(target.Mesh, pieceOfTriangle);

  result.Labels.reserve(pieceOfTriangle.size());
  for (std::size_t t = 0; t < pieceOfTriangle.size(); ++t)
  {
    const bool isKept = !guidance.KeptLabels.empty() && guidance.KeptLabels[t] != NoLabel;
    result.Labels.push_back(
      isKept ? guidance.KeptLabels[t] : pieces.LabelOfPiece[pieceOfTriangle[t]]);
  }
  SetConfidence(target, map, shares, pieces, result);
  SetMissing(numberOfPieces, labels, pieceOfTriangle, result);
  if (!parameters.StrictBoundaries)
  {
    FindTargetBoundaries(target, loops, map, pieceOfTriangle, result.Boundaries);
  }
  watched(1.0);
  return result;
}
}
