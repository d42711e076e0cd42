// SPDX-License-Identifier: BSD-3-Clause
#include "SideTransfer.h"

#include "AnswerSearch.h"
#include "FullResolution.h"

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
  return { 0, { { JoinChains(sourceSkeleton, targetSkeleton, ids), 0.0, source.Confidence } } };
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

Partner FindPartner(
  const AnalyzedSide& source, const AnalyzedMesh& target, const Progress& progress)
{
  Partner best;
  double least = std::numeric_limits<double>::infinity();
  const double size = static_cast<double>(source.Bodies.size());
  for (std::size_t b = 0; b < source.Bodies.size(); ++b)
  {
    std::vector<Answer> answers = FindAnswers(
      source.Bodies[b].Skeleton, target.Skeleton, SubProgress(progress, b / size, (b + 1) / size));
    if (answers.empty())
    {
      return best;
    }
    // Nothing matched costs nothing, and is the worst.
    const double cost =
      answers.front().Match.IsEmpty() ? std::numeric_limits<double>::max() : answers.front().Cost;
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
  const Progress& progress)
{
  constexpr double afterMatching = 0.2;
  SideTransferResult result;
  const WorkingSurface& working = target.Surface.Working;
  std::vector<int> labels(working.Mesh.Triangles.size(), 0);
  std::vector<double> confidence(working.Mesh.Triangles.size(), 0.0);
  double cost = 0.0;
  double wholeArea = 0.0;
  const double size = static_cast<double>(target.Bodies.size());
  for (std::size_t b = 0; b < target.Bodies.size(); ++b)
  {
    const Progress ofBody = SubProgress(progress, b / size, (b + 1) / size);
    const Partner partner = givenSource.IsKnown() && givenTarget.IsKnown()
      ? PartnerOf(
          givenSource, givenTarget, source.Bodies.front().Skeleton, target.Bodies[b].Skeleton)
      : FindPartner(source, target.Bodies[b], SubProgress(ofBody, 0.0, afterMatching));
    if (!Report(ofBody, afterMatching))
    {
      return result;
    }
    TransferResult ofOne = TransferSegmentation(source.Bodies[partner.SourceBody], target.Bodies[b],
      partner.Answers, labelsOfSourceBodies[partner.SourceBody], parameters,
      SubProgress(ofBody, afterMatching, 1.0));
    if (ofOne.IsAborted)
    {
      return result;
    }
    const Answer& answer = partner.Answers[ofOne.Answer];
    const double area = AreaOf(target.Bodies[b].Mesh);
    cost += area * answer.CostOfMatch();
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
    result.IsMatched = result.IsMatched && !answer.Match.IsEmpty();
    result.IsWholeAlignment = result.IsWholeAlignment || ofOne.IsWholeAlignment;
    MoveBoundaries(
      std::move(ofOne.Boundaries), source.Surface.Bodies[partner.SourceBody], body, result);
  }

  result.Cost = wholeArea > 0.0 ? cost / wholeArea : 0.0;
  CellLabels ofCells = ToCells(target.Surface, labels, confidence);
  result.Labels = std::move(ofCells.Labels);
  result.Confidence = std::move(ofCells.Confidence);
  return result;
}
}
