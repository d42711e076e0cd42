// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentationTransfer.h"

#include "BoundaryPairs.h"
#include "DenseMap.h"
#include "EdgePrices.h"
#include "FaceLabels.h"
#include "GhostBoundary.h"
#include "LabelCleanUp.h"
#include "MeshSmoother.h"
#include "NodePlaces.h"
#include "SegmentLoops.h"
#include "SkeletonMap.h"
#include "StrictBoundaries.h"
#include "TransferredPieces.h"

#include <algorithm>
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

/// The answer that is to be carried out, said in `result`.
const Answer& ChooseAnswer(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<Answer>& answers, const Guidance& guidance, const Progress& progress,
  TransferResult& result)
{
  const Answer& first = answers.front();
  // What the user gave is not judged.
  if (first.IsGiven && !first.IsWhole())
  {
    result.AnswerConfidence = first.Confidence;
    return first;
  }
  const AnswerRanking ranking = RankAnswers(source, target, answers, guidance.Hints, progress);
  result.Answer = ranking.Order[guidance.AnswerIndex];
  result.Evidence = ranking.Surfaces[result.Answer];
  result.AnswerConfidence = ConfidenceOf(result.Evidence);
  return answers[result.Answer];
}

/// The pieces' labels where they lie on the target, those of the target that are to be kept excepted.
void SetLabels(const SegmentPieces& pieces, const std::vector<int>& pieceOfTriangle,
  const std::vector<int>& keptLabels, TransferResult& result)
{
  result.Labels.reserve(pieceOfTriangle.size());
  for (std::size_t t = 0; t < pieceOfTriangle.size(); ++t)
  {
    const bool isKept = !keptLabels.empty() && keptLabels[t] != NoLabel;
    result.Labels.push_back(isKept ? keptLabels[t] : pieces.LabelOfPiece[pieceOfTriangle[t]]);
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

  const Answer& answer =
    ChooseAnswer(source, target, answers, guidance, SubProgress(watched, 0.0, 0.3), result);
  if (result.IsAborted)
  {
    return result;
  }
  SegmentPieces pieces = FindPieces(source.Mesh, labels);
  const int numberOfPieces = pieces.NumberOfPieces();
  const std::vector<SegmentLoop> loops = FindLoops(source.Mesh, pieces);
  result.Boundaries = PairsOfLoops(source, answer.Match, pieces, loops);
  const SkeletonMap skeletonMap(source, target, answer.Match,
    parameters.StrictBoundaries
      ? AlignWithLandmarks(source, target, answer.Match, parameters.Theta, parameters.Kernel)
      : AlignByProfiles(source, target, answer.Match));
  const NodePlaces places = PlaceNodes(source, target, skeletonMap);
  std::vector<bool> isTransferred = TransferredPieces(source, pieces, places.IsSourceMatched);

  std::vector<std::vector<int>> excluded; // pieces, per target triangle
  if (parameters.StrictBoundaries)
  {
    const std::vector<CarriedLoop> carried = CarryLoops(source, target, answer.Match, skeletonMap,
      { parameters.Lambda, parameters.SearchRegion }, loops, isTransferred,
      SubProgress(watched, 0.3, 0.5));
    pieces = MergePieces(pieces, loops, carried);
    isTransferred = TransferredPieces(source, pieces, places.IsSourceMatched);
    excluded =
      PiecesBeyondCurves(source.Mesh, pieces, loops, carried, target.Mesh.NumberOfTriangles());
    for (const CarriedLoop& loop : carried)
    {
      result.Boundaries[loop.Loop].TargetPoints = loop.Cut.Curve.Points;
    }
  }
  ExcludeAllButKept(pieces, guidance.KeptLabels, excluded);

  std::vector<bool> isFindable;
  for (const int piece : pieces.PieceOfTriangle)
  {
    isFindable.push_back(isTransferred[piece]);
  }
  DenseMapper mapper(source, target, isFindable, guidance.Hints);
  const DenseMap map = mapper.Map(answer, places.OfTarget, SubProgress(watched, 0.5, 0.8));
  if (!watched(0.8))
  {
    return result;
  }
  result.NumberOfUnmetHints = NumberOfUnmetHints(source, guidance.Hints, map.FoundTriangles);

  const double width = WidthFor(map);
  const MeshSmoother blend(target.Mesh, width * target.Diagonal());
  const Eigen::MatrixXd shares =
    blend.Smooth(mapper.Shares(map, pieces.PieceOfTriangle, pieces.NumberOfPieces()));
  std::vector<int> pieceOfTriangle = LabelFaces(target.Mesh, shares,
    EdgePrices(target.Mesh, EdgeConcavity(target.Mesh, blend),
      PreferenceOf(source.Mesh, pieces.PieceOfTriangle, width)),
    excluded, SubProgress(watched, 0.8, 0.95));
  if (!watched(0.95))
  {
    return result;
  }
  KeepLargestComponents(target.Mesh, pieceOfTriangle);

  SetLabels(pieces, pieceOfTriangle, guidance.KeptLabels, result);
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
