// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PairSelection_h
#define marrow_PairSelection_h

#include "Skeleton.h"

#include <utility>
#include <vector>

namespace marrow
{
/// A skeleton in a few numbers: how many loops and terminals it has, and how long and how thick the
/// branches that end at terminals are, the longest first. Skeletons that match at little cost have
/// sketches that are near each other.
std::vector<double> SketchOf(const Skeleton& skeleton);

/// How far two sketches are apart.
double SketchDistance(const std::vector<double>& first, const std::vector<double>& second);

/// In a collection of at most so many meshes all pairs are worth it.
inline constexpr int SmallCollection = 24;

/// The labelled meshes, at most eight, that are to be held back to learn from them: none of fewer than three,
/// and evenly spread ones of many. Per shape the mesh of which it is a body, and whether it is labelled.
std::vector<int> MeshesToHoldOut(
  const std::vector<int>& meshOfShape, const std::vector<bool>& isSource);

/// Per shape whether it is to be told something: if it is no source, or of a mesh that is held out.
std::vector<bool> ShapesToTell(const std::vector<int>& meshOfShape,
  const std::vector<bool>& isSource, const std::vector<int>& heldOutMeshes);

/// Which shapes are to be matched with which: pairs of their numbers, the smaller first, ascending. In a
/// small collection all of different meshes. In a larger one, which then takes time in proportion to the
/// number of meshes: each shape and the nearest by sketch; each shape that is to be told something and the
/// nearest sources; and a spanning tree, so that every shape is reached. Two shapes neither of which is to be
/// told anything are not matched.
std::vector<std::pair<int, int>> SelectPairs(const std::vector<std::vector<double>>& sketches,
  const std::vector<int>& meshOfShape, const std::vector<bool>& isSource,
  const std::vector<bool>& isTold);

/// What is known of a shape when pairs are chosen.
struct SketchedShape
{
  std::vector<double> Sketch;
  int Mesh = 0; ///< of which it is a body
  bool IsSource = false;
};
struct PairChoice
{
  std::vector<std::pair<int, int>> Pairs; ///< see SelectPairs
  std::vector<int> HeldOutMeshes;         ///< see MeshesToHoldOut; none if nothing is to be learnt
};
/// All of the above.
PairChoice ChoosePairs(const std::vector<SketchedShape>& shapes, bool learns);
}

#endif
