// SPDX-License-Identifier: BSD-3-Clause
#include "LabelSpread.h"

#include "DenseMap.h"
#include "ParallelFor.h"
#include "SharedProgress.h"
#include "SharesCut.h"
#include "SpreadRounds.h"

#include <algorithm>
#include <utility>

namespace marrow
{
namespace
{
/// Who counts less than so many others changes nothing, and each takes a while.
constexpr int MostOthers = 8;

/// The sources among a shape's tellers, and of the others those that count most.
std::vector<Teller> TellersThatCount(const CollectionGraph& graph, int shape)
{
  std::vector<std::pair<double, Teller>> others;
  std::vector<Teller> chosen;
  for (const Teller& teller : graph.GetTellers(shape))
  {
    if (graph.IsSource(teller.Shape))
    {
      chosen.push_back(teller);
    }
    else
    {
      others.emplace_back(graph.WeightOf(teller), teller);
    }
  }
  std::stable_sort(
    others.begin(), others.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t i = 0; i < others.size() && i < static_cast<std::size_t>(MostOthers); ++i)
  {
    chosen.push_back(others[i].second);
  }
  return chosen;
}

/// What the sources that a shape hears say of boundaries and pieces, by their weights.
LabelHabits HabitsFor(
  const CollectionGraph& graph, const std::vector<LabelHabits>& ofSources, int shape)
{
  LabelHabits habits;
  for (const Teller& teller : graph.GetTellers(shape))
  {
    if (graph.IsSource(teller.Shape))
    {
      habits.AddAll(ofSources[teller.Shape], graph.WeightOf(teller));
    }
  }
  return habits;
}

SpreadLabels LabelShape(
  const CollectionGraph& graph, int shape, const LabelShares& ofVertices, const LabelHabits& habits)
{
  const TriangleMesh& mesh = graph.GetShape(shape).Fine.Mesh;
  CutLabels cut = CutShares(mesh, ofVertices, graph.GetDifferentLabels(), habits, {});
  SpreadLabels result;
  result.Labels = std::move(cut.Labels);
  double total = 0.0;
  double most = 0.0;
  for (const Teller& teller : graph.GetTellers(shape))
  {
    total += graph.WeightOf(teller);
    if (graph.IsSource(teller.Shape) && graph.WeightOf(teller) > most)
    {
      most = graph.WeightOf(teller);
      result.Source = teller.Shape;
      result.Against = graph.AnswerOf(teller).Against;
      result.IsWholeAlignment = graph.AnswerOf(teller).IsWhole;
    }
  }
  const double trust = total > 0.0 ? total / (total + WeightOfEvidence(1.0)) : 0.0;
  result.Confidence = std::move(cut.Shares);
  for (double& confidence : result.Confidence)
  {
    confidence *= trust;
  }
  return result;
}
}

void ChooseTellers(CollectionGraph& graph)
{
  for (int s = 0; s < graph.NumberOfShapes(); ++s)
  {
    graph.SetTellers(s, TellersThatCount(graph, s));
  }
}

bool CarryMaps(CollectionGraph& graph, const Progress& progress)
{
  SharedProgress shared(progress);
  const double share = 1.0 / std::max(graph.NumberOfShapes(), 1);
  ParallelFor(0, graph.NumberOfShapes(),
    [&](int first, int last)
    {
      for (int s = first; s < last; ++s)
      {
        const std::vector<Teller>& tellers = graph.GetTellers(s);
        if (tellers.empty())
        {
          shared.Add(share);
          continue;
        }
        const auto smoother = DenseMapper::SmootherOf(graph.GetShape(s).Fine);
        for (const Teller& teller : tellers)
        {
          CollectionLink& link = graph.GetLinks()[teller.Link];
          link.Pair->Carry(teller.Side, link.Answer, smoother, {});
          if (!shared.Add(share / tellers.size()))
          {
            return;
          }
        }
      }
    });
  return shared.Add(0.0);
}

std::vector<LabelShares> SpreadShares(const CollectionGraph& graph)
{
  std::vector<LabelShares> ofTriangles(graph.NumberOfShapes());
  for (int s = 0; s < graph.NumberOfShapes(); ++s)
  {
    if (graph.IsSource(s))
    {
      ofTriangles[s] = SharesOfLabels(graph.GetLabels(s), graph.GetDifferentLabels());
    }
  }
  return SpreadInRounds(
    graph,
    [&](const Teller& teller)
    {
      const CollectionLink& link = graph.GetLinks()[teller.Link];
      const CarriedMap& map = link.Pair->GetCarried(teller.Side, link.Answer);
      return ShareLink{ nullptr, &map.FoundTriangles, &map.Certainty };
    },
    [&](int shape) -> const TriangleMesh& { return graph.GetShape(shape).Fine.Mesh; }, ofTriangles);
}

std::vector<SpreadLabels> LabelShapes(const CollectionGraph& graph,
  const std::vector<LabelShares>& ofVertices, const Progress& progress)
{
  std::vector<LabelHabits> habits(graph.NumberOfShapes());
  for (int s = 0; s < graph.NumberOfShapes(); ++s)
  {
    if (graph.IsSource(s))
    {
      habits[s].Add(graph.GetShape(s).Fine.Mesh, graph.GetLabels(s), 1.0);
    }
  }
  std::vector<SpreadLabels> result(graph.NumberOfShapes());
  SharedProgress shared(progress);
  ParallelFor(0, graph.NumberOfShapes(),
    [&](int first, int last)
    {
      for (int s = first; s < last; ++s)
      {
        if (!graph.IsSource(s))
        {
          result[s] = LabelShape(graph, s, ofVertices[s], HabitsFor(graph, habits, s));
        }
        if (!shared.Add(1.0 / graph.NumberOfShapes()))
        {
          return;
        }
      }
    });
  return result;
}
}
