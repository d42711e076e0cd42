// SPDX-License-Identifier: BSD-3-Clause
#include "SideTransfer.h"

#include "AnswerSearch.h"
#include "FullResolution.h"
#include "OtherAnswers.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
/// The answer that the skeletons bring with them, which both meshes belong to as wholes.
Partner PartnerOf(const GivenCorrespondence& source, const GivenCorrespondence& target,
  const Skeleton& sourceSkeleton, const Skeleton& targetSkeleton)
{
  const CorrespondenceIds ids{ source.Nodes, target.Nodes, source.Branches, target.Branches,
    source.Order, target.Order };
  return { 0,
    { { JoinChains(sourceSkeleton, targetSkeleton, ids), 0.0, source.Confidence, 0.0, true } } };
}

struct BodyVertex
{
  std::size_t Body = 0;
  int Vertex = 0;
};

BodyVertex NearestVertex(const PreparedSurface& surface, const Eigen::Vector3d& point)
{
  BodyVertex nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < surface.Bodies.size(); ++b)
  {
    const Body& body = surface.Bodies[b];
    const Eigen::Vector3d inFrame = body.Frame.ToFrame(point);
    for (int v = 0; v < body.Mesh.NumberOfVertices(); ++v)
    {
      const double distance = body.Frame.LengthFromFrame((body.Mesh.Points[v] - inFrame).norm());
      if (distance < least)
      {
        least = distance;
        nearest = { b, v };
      }
    }
  }
  return nearest;
}

/// Per body of the target the hints about it.
std::vector<std::vector<BodyHint>> HintsOfBodies(
  const PreparedSurface& source, const PreparedSurface& target, const std::vector<PointHint>& hints)
{
  std::vector<std::vector<BodyHint>> ofBodies(target.Bodies.size());
  for (const PointHint& hint : hints)
  {
    const BodyVertex there = NearestVertex(source, hint.Source);
    const BodyVertex here = NearestVertex(target, hint.Target);
    ofBodies[here.Body].push_back({ there.Body, { there.Vertex, here.Vertex, hint.IsForbidden } });
  }
  return ofBodies;
}

std::vector<SurfaceHint> HintsOfPair(std::size_t sourceBody, const std::vector<BodyHint>& hints)
{
  std::vector<SurfaceHint> result;
  for (const BodyHint& hint : hints)
  {
    if (hint.SourceBody == sourceBody)
    {
      result.push_back(hint.Hint);
    }
  }
  return result;
}

/// Whether hints leave it open that a target with them belongs to this body of the source.
bool MayBePartner(std::size_t sourceBody, const std::vector<BodyHint>& hints)
{
  const auto isWanted = [](const BodyHint& hint) { return !hint.Hint.IsForbidden; };
  return std::none_of(hints.begin(), hints.end(), isWanted) ||
    std::any_of(hints.begin(), hints.end(),
      [&](const BodyHint& hint) { return isWanted(hint) && hint.SourceBody == sourceBody; });
}

double AreaOf(const TriangleMesh& mesh)
{
  const std::vector<double> areas = mesh.TriangleAreas();
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

void MoveBoundaries(std::vector<BoundaryPair> pairs, const Body& source, const Body& target,
  SideTransferResult& result)
{
  for (BoundaryPair& pair : pairs)
  {
    for (Eigen::Vector3d& point : pair.SourcePoints)
    {
      point = source.Frame.FromFrame(point);
    }
    for (Eigen::Vector3d& point : pair.TargetPoints)
    {
      point = target.Frame.FromFrame(point);
    }
    result.Boundaries.push_back(std::move(pair));
  }
}
}

Partner FindPartner(const AnalyzedSide& source, const AnalyzedMesh& target,
  const std::vector<BodyHint>& hints, const Progress& progress)
{
  Partner best;
  double least = std::numeric_limits<double>::infinity();
  const double size = static_cast<double>(source.Bodies.size());
  for (std::size_t b = 0; b < source.Bodies.size(); ++b)
  {
    if (!MayBePartner(b, hints))
    {
      continue;
    }
    std::vector<Answer> answers = FindAnswers(source.Bodies[b].Skeleton, target.Skeleton,
      ToNodeHints(source.Bodies[b], target, HintsOfPair(b, hints)),
      SubProgress(progress, b / size, (b + 1) / size));
    if (answers.empty())
    {
      return best;
    }
    // Nothing matched costs nothing, and is the worst.
    const double cost =
      answers.front().IsWhole() ? std::numeric_limits<double>::max() : answers.front().Cost;
    if (cost < least)
    {
      least = cost;
      best = { b, std::move(answers) };
    }
  }
  return best;
}

CellLabels ToCells(const PreparedSurface& surface, const std::vector<int>& labelOfTriangle,
  const std::vector<double>& confidenceOfTriangle)
{
  const WorkingSurface& working = surface.Working;
  const std::vector<int> ofPolygons =
    LabelsOfPolygons(working, LabelsAtFullResolution(working, labelOfTriangle));
  CellLabels result;
  result.Labels.assign(surface.NumberOfCells, -1);
  result.Confidence.assign(surface.NumberOfCells, 0.0);
  for (std::size_t p = 0; p < ofPolygons.size(); ++p)
  {
    const int cell = surface.CellOfPolygon[p];
    result.Labels[cell] = ofPolygons[p];
    result.Confidence[cell] = confidenceOfTriangle[working.TriangleOfCell(static_cast<int>(p))];
  }
  return result;
}

SideTransferResult TransferSide(const AnalyzedSide& source, const AnalyzedSide& target,
  const GivenCorrespondence& givenSource, const GivenCorrespondence& givenTarget,
  const std::vector<std::vector<int>>& labelsOfSourceBodies, const TransferParameters& parameters,
  const SideGuidance& guidance, const Progress& progress)
{
  constexpr double afterMatching = 0.2;
  SideTransferResult result;
  const std::vector<std::vector<BodyHint>> hints =
    HintsOfBodies(source.Surface, target.Surface, guidance.Hints);
  const WorkingSurface& working = target.Surface.Working;
  std::vector<int> labels(working.Mesh.Triangles.size(), 0);
  std::vector<double> confidence(working.Mesh.Triangles.size(), 0.0);
  double wholeArea = 0.0;
  const double size = static_cast<double>(target.Bodies.size());
  for (std::size_t b = 0; b < target.Bodies.size(); ++b)
  {
    const Progress ofBody = SubProgress(progress, b / size, (b + 1) / size);
    const bool isGiven = givenSource.IsKnown() && givenTarget.IsKnown();
    Partner partner = isGiven
      ? PartnerOf(
          givenSource, givenTarget, source.Bodies.front().Skeleton, target.Bodies[b].Skeleton)
      : FindPartner(source, target.Bodies[b], hints[b], SubProgress(ofBody, 0.0, afterMatching));
    if (!Report(ofBody, afterMatching))
    {
      return result;
    }
    // The paper knows skeletons alone.
    if (!isGiven && !parameters.StrictBoundaries)
    {
      PreferSlices(source.Bodies[partner.SourceBody], target.Bodies[b], partner.Answers);
    }
    if (!isGiven)
    {
      AddWhole(source.Bodies[partner.SourceBody], target.Bodies[b], partner.Answers);
    }
    const int numberOfAnswers = static_cast<int>(partner.Answers.size());
    if (guidance.AnswerIndex >= numberOfAnswers)
    {
      result.Error = "AnswerIndex is " + std::to_string(guidance.AnswerIndex) +
        ", but the number of answers is " + std::to_string(numberOfAnswers) +
        ": set it to less than that.";
      return result;
    }
    Guidance ofPair;
    ofPair.Hints = HintsOfPair(partner.SourceBody, hints[b]);
    ofPair.AnswerIndex = guidance.AnswerIndex;
    if (!guidance.KeptLabels.empty())
    {
      ofPair.KeptLabels =
        LabelsOfBody(target.Surface, target.Surface.Bodies[b], guidance.KeptLabels);
    }
    TransferResult ofOne = TransferSegmentation(source.Bodies[partner.SourceBody], target.Bodies[b],
      partner.Answers, labelsOfSourceBodies[partner.SourceBody], parameters, ofPair,
      SubProgress(ofBody, afterMatching, 1.0));
    if (ofOne.IsAborted)
    {
      return result;
    }
    const Answer& answer = partner.Answers[ofOne.Answer];
    const double area = AreaOf(target.Bodies[b].Mesh);
    result.Cost += area * (answer.IsWhole() ? 1.0 : answer.Cost);
    result.Evidence += area * ofOne.Evidence;
    result.AnswerConfidence += area * ofOne.AnswerConfidence;
    wholeArea += area;
    const Body& body = target.Surface.Bodies[b];
    for (std::size_t t = 0; t < ofOne.Labels.size(); ++t)
    {
      labels[body.OriginalTriangle[t]] = ofOne.Labels[t];
      confidence[body.OriginalTriangle[t]] = ofOne.Confidence[t];
    }
    result.MissingLabels.insert(ofOne.MissingLabels.begin(), ofOne.MissingLabels.end());
    result.NumberOfMissingPieces =
      std::max(result.NumberOfMissingPieces, ofOne.NumberOfMissingPieces);
    result.NumberOfUnmetHints += ofOne.NumberOfUnmetHints;
    result.IsMatched = result.IsMatched && !partner.Answers.front().IsWhole();
    result.IsWholeAlignment = result.IsWholeAlignment || answer.IsWhole();
    result.MatchedBy.emplace_back(
      answer.IsWhole() ? "whole" : (answer.Slices ? "slices" : "skeletons"));
    MoveBoundaries(
      std::move(ofOne.Boundaries), source.Surface.Bodies[partner.SourceBody], body, result);
  }

  for (double* mean : { &result.Cost, &result.Evidence, &result.AnswerConfidence })
  {
    *mean = wholeArea > 0.0 ? *mean / wholeArea : 0.0;
  }
  CellLabels ofCells = ToCells(target.Surface, labels, confidence);
  result.Labels = std::move(ofCells.Labels);
  result.Confidence = std::move(ofCells.Confidence);
  for (std::size_t cell = 0; cell < guidance.KeptLabels.size(); ++cell)
  {
    const int kept = guidance.KeptLabels[cell];
    if (kept != NoLabel)
    {
      result.Labels[cell] = kept;
      result.Confidence[cell] = 1.0;
    }
  }
  return result;
}
}
