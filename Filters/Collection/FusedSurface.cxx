// SPDX-License-Identifier: BSD-3-Clause
#include "FusedSurface.h"

#include "AnalyzedSide.h"
#include "SharesCut.h"

#include <algorithm>

namespace marrow
{
namespace
{
/// The shares of the triangles of the working surface: the mean over the area of the cells that became
/// each; 0 where a hole was filled.
LabelShares SharesOfWorking(const PreparedSurface& surface, const LabelShares& ofCells)
{
  const WorkingSurface& working = surface.Working;
  LabelShares shares = LabelShares::Zero(working.Mesh.NumberOfTriangles(), ofCells.cols());
  for (int t = 0; t < working.Full.NumberOfTriangles(); ++t)
  {
    const int polygon = working.CellOfFullTriangle[t];
    if (polygon >= 0)
    {
      shares.row(working.TriangleOfFullTriangle[t]) +=
        static_cast<float>(working.Full.Area(t)) * ofCells.row(surface.CellOfPolygon[polygon]);
    }
  }
  SharpenShares(shares, 1.0);
  return shares;
}

LabelShares SharesOfVertices(const Body& body, const LabelShares& ofWorking)
{
  LabelShares shares = LabelShares::Zero(body.Mesh.NumberOfVertices(), ofWorking.cols());
  for (int t = 0; t < body.Mesh.NumberOfTriangles(); ++t)
  {
    for (const int corner : body.Mesh.Triangles[t])
    {
      shares.row(corner) +=
        static_cast<float>(body.Mesh.Area(t)) * ofWorking.row(body.OriginalTriangle[t]);
    }
  }
  SharpenShares(shares, 1.0);
  return shares;
}

bool IsUnanimous(const std::vector<Labelling>& labellings, std::size_t face)
{
  return std::all_of(labellings.begin(), labellings.end(),
    [&](const Labelling& labelling)
    { return labelling.Labels[face] == labellings.front().Labels[face]; });
}
}

std::vector<double> AreaOfCells(const PreparedSurface& surface)
{
  std::vector<double> areas(surface.NumberOfCells, 0.0);
  for (int t = 0; t < surface.Working.Full.NumberOfTriangles(); ++t)
  {
    const int polygon = surface.Working.CellOfFullTriangle[t];
    if (polygon >= 0)
    {
      areas[surface.CellOfPolygon[polygon]] += surface.Working.Full.Area(t);
    }
  }
  return areas;
}

CellLabels FuseOnSurface(const PreparedSurface& surface, const LabelVotes& votes,
  const std::vector<Labelling>& labellings, const Progress& progress)
{
  const LabelShares ofWorking = SharesOfWorking(surface, votes.Shares);
  std::vector<int> labels(surface.Working.Mesh.Triangles.size(), 0);
  std::vector<double> shares(labels.size(), 0.0);
  const double size = static_cast<double>(surface.Bodies.size());
  for (std::size_t b = 0; b < surface.Bodies.size(); ++b)
  {
    const Body& body = surface.Bodies[b];
    LabelHabits habits;
    for (const Labelling& labelling : labellings)
    {
      habits.Add(body.Mesh, LabelsOfBody(surface, body, labelling.Labels), labelling.Weight);
    }
    const CutLabels cut = CutShares(body.Mesh, SharesOfVertices(body, ofWorking), votes.Labels,
      habits, SubProgress(progress, b / size, (b + 1) / size));
    for (std::size_t t = 0; t < cut.Labels.size(); ++t)
    {
      labels[body.OriginalTriangle[t]] = cut.Labels[t];
      shares[body.OriginalTriangle[t]] = cut.Shares[t];
    }
  }
  CellLabels result = ToCells(surface, labels, shares);
  for (std::size_t c = 0; c < result.Labels.size(); ++c)
  {
    if (IsUnanimous(labellings, c))
    {
      result.Labels[c] = labellings.front().Labels[c];
    }
    // What those who say so think of it themselves.
    double sum = 0.0;
    double total = 0.0;
    for (const Labelling& labelling : labellings)
    {
      if (labelling.Labels[c] == result.Labels[c])
      {
        sum += labelling.Weight * (labelling.Confidence.empty() ? 1.0 : labelling.Confidence[c]);
        total += labelling.Weight;
      }
    }
    result.Confidence[c] =
      std::clamp(result.Confidence[c] * (total > 0.0 ? sum / total : 0.0), 0.0, 1.0);
  }
  return result;
}
}
