// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SharesCut_h
#define marrow_SharesCut_h

#include "LabelShares.h"
#include "Progress.h"
#include "TriangleMesh.h"

#include <map>
#include <vector>

namespace marrow
{
/// What labelled surfaces say about how their labels may lie on another.
class LabelHabits
{
public:
  /// Adds a labelled surface, which counts by `weight`.
  void Add(const TriangleMesh& mesh, const std::vector<int>& labels, double weight);

  /// How much boundaries keep to concave edges, the weighted mean (ConcavityPreference).
  double Preference() const { return this->Weight > 0.0 ? this->Sum / this->Weight : 0.0; }
  /// The area of the smallest connected piece of a label on any of the surfaces, of the whole; 0 if it has
  /// none.
  double SmallestPiece(int label) const;

  /// The same with other weights, so that a surface is looked at once only.
  void AddAll(const LabelHabits& other, double weight);

private:
  double Sum = 0.0;
  double Weight = 0.0;
  std::map<int, double> Smallest;
};

/// One labelling made of shares.
struct CutLabels
{
  std::vector<int> Labels;    ///< per triangle
  std::vector<double> Shares; ///< per triangle: of its label, [0,1]
};

/// Labels all triangles by one cut (LabelFaces). `shares` are per vertex, a column for each of `labels`;
/// they are blended over BlendWidth before. Islands much smaller than any piece that the habits know of
/// their label join a neighbour.
CutLabels CutShares(const TriangleMesh& mesh, const LabelShares& shares,
  const std::vector<int>& labels, const LabelHabits& habits, const Progress& progress);
}

#endif
