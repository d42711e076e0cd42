// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PairBatch_h
#define marrow_PairBatch_h

#include "CollectedMeshes.h"
#include "CollectedPairs.h"
#include "Progress.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

namespace marrow
{
/// A mesh of a collection, as far as pairs have to know it.
struct CollectionMember
{
  vtkPolyData* Mesh = nullptr;
  bool IsSource = false;
};

/// Of each end of a pair the member and its body.
using PairEnds = std::array<std::pair<int, int>, 2>;

/// Maps that are wanted of one pair.
struct WantedMaps
{
  PairEnds Ends;
  std::vector<std::pair<int, std::size_t>> OfAnswers; ///< side and answer, as ShapePair::Carry
};

/// Some pairs of a collection, as many as are held at a time, whose results go to files.
class PairBatch
{
public:
  PairBatch(const std::vector<CollectionMember>& members, std::string folder);

  /// Matches these pairs, unless a file of the folder has them, in place of those before; of the meshes those that
  /// were there before are kept. False if `progress` asked to stop.
  bool Collect(const std::vector<PairEnds>& ends, const Progress& progress);
  /// Carries out maps, those at i of the pair i, and writes them.
  void Carry(const std::vector<WantedMaps>& wanted);

private:
  const CollectionShape& ShapeOf(std::size_t pair, int side) const
  {
    return side == 0 ? *this->Ends[pair].first : *this->Ends[pair].second;
  }

  const std::vector<CollectionMember>& Members;
  std::string Folder;
  CollectedMeshes Meshes;
  CollectedPairs Known;
  std::vector<CollectedPairs::Ends> Ends;
  std::vector<ShapePair*> Pairs;
};
}

#endif
