// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BranchLikeness_h
#define marrow_BranchLikeness_h

#include "FeatureGraph.h"

#include <vector>

namespace marrow
{
/// How unlike two paths of branches are, whatever the pose: 0 for the same, about 1 for a tail and
/// a body. The sum of the differences in length (as fractions of the skeletons), MSP profile, AGD
/// profile and AGD at the far end.
double PathUnlikeness(const FeatureGraph& source, const std::vector<int>& sourcePath,
  const FeatureGraph& target, const std::vector<int>& targetPath);
}

#endif
