// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LoopDirection_h
#define marrow_LoopDirection_h

#include "FeatureCorrespondence.h"

namespace marrow
{
/// Which way round a loop of the target runs along with one of the source, both at the matched nodes
/// `nodes`: `targetDart` or its opposite. The directions of the branches that are matched there decide
/// together with what the loops are like on the way.
int DirectLoop(const FeatureGraph& source, const FeatureGraph& target,
  const FeatureCorrespondence& match, int nodes, int sourceDart, int targetDart);
}

#endif
