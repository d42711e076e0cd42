// SPDX-License-Identifier: BSD-3-Clause
#include "RejectedAnswers.h"

#include "CoarseShares.h"

#include <algorithm>
#include <utility>

namespace marrow
{
namespace
{
/// Boundaries that run elsewhere are no other answer: coarse vertices are a thirtieth of the surface's size apart.
constexpr double LeastDifference = 0.05;

/// Per row the column of the largest share.
std::vector<int> LikeliestColumns(const LabelShares& shares)
{
  std::vector<int> columns(static_cast<std::size_t>(shares.rows()), 0);
  for (Eigen::Index row = 0; row < shares.rows(); ++row)
  {
    shares.row(row).maxCoeff(&columns[static_cast<std::size_t>(row)]);
  }
  return columns;
}

/// The share of the area on which two labellings of coarse vertices differ.
double Difference(
  const CoarseMesh& coarse, const std::vector<int>& one, const std::vector<int>& other)
{
  double sum = 0.0;
  for (std::size_t v = 0; v < one.size(); ++v)
  {
    sum += one[v] != other[v] ? coarse.Shares[v] : 0.0;
  }
  return sum;
}

/// Each triangle has the label of two of its corners, or else that of the first.
std::vector<int> LabelsOfTriangles(const CollectionShape& shape,
  const std::vector<int>& columnOfCell, const std::vector<int>& differentLabels)
{
  std::vector<int> labels;
  for (const auto& [a, b, c] : shape.Fine.Mesh.Triangles)
  {
    const auto columnOf = [&](int vertex)
    { return columnOfCell[shape.Coarse.CellOfVertex[vertex]]; };
    labels.push_back(differentLabels[columnOf(b) == columnOf(c) ? columnOf(b) : columnOf(a)]);
  }
  return labels;
}
}

std::vector<RejectedAnswer> FindRejectedAnswers(const CollectionGraph& graph, int shape, int source,
  const std::vector<int>& labels, std::size_t most)
{
  const std::vector<Teller>& tellers = graph.GetTellers(shape);
  const auto teller = std::find_if(
    tellers.begin(), tellers.end(), [source](const Teller& of) { return of.Shape == source; });
  if (teller == tellers.end() || most == 0)
  {
    return {};
  }
  const CollectionShape& told = graph.GetShape(shape);
  const std::vector<int>& differentLabels = graph.GetDifferentLabels();
  const LabelShares ofSource =
    CoarseSharesOfLabels(graph.GetShape(source), graph.GetLabels(source), differentLabels);
  const std::vector<int> got = LikeliestColumns(
    SharesOfCells(told.Fine.Mesh, told.Coarse, SharesOfLabels(labels, differentLabels)));
  const CollectionLink& link = graph.GetLinks()[teller->Link];
  struct Candidate
  {
    std::vector<int> Columns; ///< per coarse vertex
    double Against;
    double Difference;
  };
  const auto carryOut = [&](std::size_t answer)
  {
    std::vector<int> columns =
      LikeliestColumns(TellCoarsely(graph, ofSource, *teller, answer, 1.0));
    const double difference = Difference(told.Coarse, columns, got);
    return Candidate{ std::move(columns), link.Pair->GetAnswers()[answer].Against, difference };
  };
  std::vector<Candidate> candidates;
  for (std::size_t a = 0; a < link.Pair->GetAnswers().size(); ++a)
  {
    if (a != link.Answer)
    {
      candidates.push_back(carryOut(a));
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& one, const Candidate& other)
    { return one.Against + one.Difference < other.Against + other.Difference; });
  std::vector<std::vector<int>> seen{ got, carryOut(link.Answer).Columns };
  std::vector<RejectedAnswer> rejected;
  for (Candidate& candidate : candidates)
  {
    const bool isAnother = std::all_of(seen.begin(), seen.end(),
      [&](const std::vector<int>& columns)
      { return Difference(told.Coarse, candidate.Columns, columns) >= LeastDifference; });
    if (isAnother && rejected.size() < most)
    {
      rejected.push_back({ LabelsOfTriangles(told, candidate.Columns, differentLabels),
        candidate.Against, candidate.Difference });
      seen.push_back(std::move(candidate.Columns));
    }
  }
  return rejected;
}
}
