// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionGraph.h"

#include <cmath>
#include <map>
#include <utility>

namespace marrow
{
namespace
{
/// What speaks against the answers of one collection differs by 0.5 and more: the best counts twenty times
/// as much as the worst. Measured, anything from 4 to 8 does.
constexpr double EvidenceFactor = 6.0;
/// What is known counts more than what was found out; from 2 to 4, and hardly less at 1.
constexpr double WeightOfSources = 2.0;
/// An alignment as wholes knows nothing of parts.
constexpr double WeightOfWholes = 0.5;
}

CollectionGraph::CollectionGraph(std::vector<const CollectionShape*> shapes,
  std::vector<int> meshOfShape, std::vector<std::vector<int>> labels,
  std::vector<CollectionLink> links)
  : Shapes(std::move(shapes))
  , MeshOfShape(std::move(meshOfShape))
  , Labels(std::move(labels))
  , DifferentLabels(marrow::DifferentLabels(this->Labels))
  , Links(std::move(links))
  , Tellers(this->Shapes.size())
{
  std::vector<std::vector<Teller>> ends(this->Shapes.size());
  for (std::size_t l = 0; l < this->Links.size(); ++l)
  {
    CollectionLink& link = this->Links[l];
    link.Answer = link.Pair->LikeliestAnswer();
    link.Disagreement = 0.0;
    for (int side = 0; side < 2; ++side)
    {
      ends[link.Shapes[side]].push_back({ static_cast<int>(l), side, link.Shapes[1 - side] });
    }
  }
  for (int s = 0; s < this->NumberOfShapes(); ++s)
  {
    if (!this->IsSource(s))
    {
      this->AddTellers(s, ends[s]);
    }
  }
}

CollectionGraph CollectionGraph::WithoutLabelsOf(int mesh) const
{
  std::vector<std::vector<int>> labels = this->Labels;
  for (int s = 0; s < this->NumberOfShapes(); ++s)
  {
    if (this->MeshOfShape[s] == mesh)
    {
      labels[s].clear();
    }
  }
  CollectionGraph without(this->Shapes, this->MeshOfShape, std::move(labels), this->Links);
  // So that the columns of the shares stay the same.
  without.DifferentLabels = this->DifferentLabels;
  return without;
}

void CollectionGraph::AddTellers(int shape, const std::vector<Teller>& ends)
{
  std::map<int, Teller> ofMeshes;
  for (const Teller& end : ends)
  {
    const auto [entry, isNew] = ofMeshes.insert({ this->MeshOfShape[end.Shape], end });
    if (!isNew && this->AnswerOf(end).Cost < this->AnswerOf(entry->second).Cost)
    {
      entry->second = end;
    }
  }
  // In the order of the ends, which is that of the contents.
  for (const Teller& end : ends)
  {
    if (ofMeshes.at(this->MeshOfShape[end.Shape]).Link == end.Link)
    {
      this->Tellers[shape].push_back(end);
    }
  }
}

void CollectionGraph::SetTellers(int shape, std::vector<Teller> tellers)
{
  this->Tellers[shape] = std::move(tellers);
}

double CollectionGraph::WeightOf(const Teller& teller) const
{
  const TriedAnswer& answer = this->AnswerOf(teller);
  return WeightOfEvidence(answer.Against) * (answer.IsWhole ? WeightOfWholes : 1.0) *
    (this->IsSource(teller.Shape) ? WeightOfSources : 1.0);
}

double WeightOfEvidence(double against)
{
  return std::exp(-EvidenceFactor * against);
}
}
