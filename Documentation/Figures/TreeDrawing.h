// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TreeDrawing_h
#define marrow_TreeDrawing_h

#include "Canvas.h"
#include "CorrespondenceTree.h"
#include "LeafSelection.h"

namespace figures
{
/// Two skeletons with a letter at each feature node, and the way to the best leaves of their
/// correspondence tree as pairs of these letters. `leaves` are in order, the best first.
Picture DrawCorrespondenceTree(const marrow::Skeleton& source,
  const marrow::FeatureGraph& sourceGraph, const marrow::Skeleton& target,
  const marrow::FeatureGraph& targetGraph, const std::vector<marrow::RatedLeaf>& leaves);
}

#endif
