// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionGraph_h
#define marrow_CollectionGraph_h

#include "CollectionShape.h"
#include "LabelShares.h"
#include "ShapePair.h"

#include <array>
#include <vector>

namespace marrow
{
/// Two shapes of a collection that were matched, by their numbers, and the answer that is believed.
struct CollectionLink
{
  std::array<int, 2> Shapes{};
  ShapePair* Pair = nullptr;
  std::size_t Answer = 0;
  /// How far what the answer carries is from what the others say, [0,1]; 0 where there are no others.
  double Disagreement = 0.0;
};

/// Someone who tells a shape its labels: the other end of one of its links.
struct Teller
{
  int Link = -1;
  int Side = 0; ///< which end of the link is told
  int Shape = -1;
};

/// How much an answer counts against which so much is to be said (Evidence's sum).
double WeightOfEvidence(double against);

/// Shapes some of which have labels, and the links by which the labels spread.
class CollectionGraph
{
public:
  /// Per shape the mesh of which it is a body, and the labels of its triangles, empty where they are to be
  /// found. Every pair is known. Of the bodies of one mesh a shape hears the one that matches it at the least
  /// cost. The order of shapes and links decides nothing but the order of sums.
  CollectionGraph(std::vector<const CollectionShape*> shapes, std::vector<int> meshOfShape,
    std::vector<std::vector<int>> labels, std::vector<CollectionLink> links);

  int NumberOfShapes() const { return static_cast<int>(this->Shapes.size()); }
  const CollectionShape& GetShape(int shape) const { return *this->Shapes[shape]; }
  bool IsSource(int shape) const { return !this->Labels[shape].empty(); }
  const std::vector<int>& GetLabels(int shape) const { return this->Labels[shape]; }
  /// All that occur, ascending: the columns of shares.
  const std::vector<int>& GetDifferentLabels() const { return this->DifferentLabels; }
  int NumberOfLabels() const { return static_cast<int>(this->DifferentLabels.size()); }

  std::vector<CollectionLink>& GetLinks() { return this->Links; }
  const std::vector<CollectionLink>& GetLinks() const { return this->Links; }
  /// Who tells a shape; nobody tells a source.
  const std::vector<Teller>& GetTellers(int shape) const { return this->Tellers[shape]; }
  /// The mesh of which a shape is a body.
  int MeshOf(int shape) const { return this->MeshOfShape[shape]; }
  /// The same shapes and links, the answers not voted on yet, with the labels of a mesh forgotten.
  CollectionGraph WithoutLabelsOf(int mesh) const;

  void SetTellers(int shape, std::vector<Teller> tellers);

  const TriedAnswer& AnswerOf(const Teller& teller) const
  {
    const CollectionLink& link = this->Links[teller.Link];
    return link.Pair->GetAnswers()[link.Answer];
  }
  /// How much a teller counts: the less the more speaks against its answer.
  double WeightOf(const Teller& teller) const;

private:
  void AddTellers(int shape, const std::vector<Teller>& ends);

  std::vector<const CollectionShape*> Shapes;
  std::vector<int> MeshOfShape;
  std::vector<std::vector<int>> Labels;
  std::vector<int> DifferentLabels;
  std::vector<CollectionLink> Links;
  std::vector<std::vector<Teller>> Tellers;
};
}

#endif
