// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerVote.h"

#include "CoarseShares.h"
#include "LabelShares.h"
#include "SpreadRounds.h"

#include <algorithm>
#include <vector>

namespace marrow
{
namespace
{
/// The second round sees the choices of the first.
constexpr int NumberOfVotes = 2;
/// Smaller differences are rounding.
constexpr double LeastGain = 1e-3;

std::vector<LabelShares> SharesOfCoarseSources(const CollectionGraph& graph)
{
  std::vector<LabelShares> shares(graph.NumberOfShapes());
  for (int s = 0; s < graph.NumberOfShapes(); ++s)
  {
    if (graph.IsSource(s))
    {
      shares[s] =
        CoarseSharesOfLabels(graph.GetShape(s), graph.GetLabels(s), graph.GetDifferentLabels());
    }
  }
  return shares;
}

/// The share of the area on which two labellings differ.
double Difference(
  const LabelShares& one, const LabelShares& other, const std::vector<double>& shareOfVertex)
{
  double agreement = 0.0;
  for (std::size_t v = 0; v < shareOfVertex.size(); ++v)
  {
    const auto row = static_cast<Eigen::Index>(v);
    agreement += shareOfVertex[v] * one.row(row).dot(other.row(row));
  }
  return std::clamp(1.0 - agreement, 0.0, 1.0);
}

/// Per link and answer the mean difference from the rest, at the ends that have one.
struct Ballot
{
  std::vector<double> Differences;
  int NumberOfEnds = 0;
};

void AddVotesAt(const CollectionGraph& graph, const std::vector<LabelShares>& ofTriangles,
  int shape, std::vector<Ballot>& ballots)
{
  const std::vector<Teller>& tellers = graph.GetTellers(shape);
  const CoarseMesh& coarse = graph.GetShape(shape).Coarse;
  std::vector<LabelShares> told;
  LabelShares all = LabelShares::Zero(coarse.Side.Mesh.NumberOfVertices(), graph.NumberOfLabels());
  for (const Teller& teller : tellers)
  {
    const CollectionLink& link = graph.GetLinks()[teller.Link];
    told.push_back(
      TellCoarsely(graph, ofTriangles[teller.Shape], teller, link.Answer, graph.WeightOf(teller)));
    all += told.back();
  }
  for (std::size_t i = 0; i < tellers.size(); ++i)
  {
    LabelShares rest = (all - told[i]).cwiseMax(0.0f);
    SharpenShares(rest, 1.0);
    Ballot& ballot = ballots[tellers[i].Link];
    for (std::size_t a = 0; a < ballot.Differences.size(); ++a)
    {
      ballot.Differences[a] += Difference(rest,
        TellCoarsely(graph, ofTriangles[tellers[i].Shape], tellers[i], a, 1.0), coarse.Shares);
    }
    ++ballot.NumberOfEnds;
  }
}

void Choose(CollectionLink& link, const Ballot& ballot)
{
  if (ballot.NumberOfEnds == 0)
  {
    return;
  }
  const std::vector<TriedAnswer>& answers = link.Pair->GetAnswers();
  const auto against = [&](std::size_t a)
  { return answers[a].Against + ballot.Differences[a] / ballot.NumberOfEnds; };
  link.Answer = 0;
  for (std::size_t a = 1; a < answers.size(); ++a)
  {
    if (against(a) < against(link.Answer) - LeastGain)
    {
      link.Answer = a;
    }
  }
  link.Disagreement = ballot.Differences[link.Answer] / ballot.NumberOfEnds;
}
}

bool VoteOnAnswers(CollectionGraph& graph, const Progress& progress)
{
  const std::vector<LabelShares> ofSources = SharesOfCoarseSources(graph);
  for (int vote = 0; vote < NumberOfVotes; ++vote)
  {
    const auto done = [&](double part) { return (vote + part) / NumberOfVotes; };
    std::vector<LabelShares> ofTriangles = ofSources;
    SpreadInRounds(
      graph,
      [&](const Teller& teller) {
        return ShareLink{ nullptr, &graph.AnswerOf(teller).FoundTriangles[teller.Side] };
      },
      [&](int shape) -> const TriangleMesh& { return graph.GetShape(shape).Coarse.Side.Mesh; },
      ofTriangles);
    std::vector<Ballot> ballots;
    for (const CollectionLink& link : graph.GetLinks())
    {
      ballots.push_back({ std::vector<double>(link.Pair->GetAnswers().size(), 0.0), 0 });
    }
    for (int s = 0; s < graph.NumberOfShapes(); ++s)
    {
      if (!Report(progress, done(static_cast<double>(s) / graph.NumberOfShapes())))
      {
        return false;
      }
      // Of one teller there is no rest.
      if (graph.GetTellers(s).size() > 1)
      {
        AddVotesAt(graph, ofTriangles, s, ballots);
      }
    }
    for (std::size_t l = 0; l < ballots.size(); ++l)
    {
      Choose(graph.GetLinks()[l], ballots[l]);
    }
  }
  return true;
}
}
