// SPDX-License-Identifier: BSD-3-Clause
#include "BranchLikeness.h"

#include <cmath>

namespace marrow
{
double PathUnlikeness(const FeatureGraph& source, const std::vector<int>& sourcePath,
  const FeatureGraph& target, const std::vector<int>& targetPath)
{
  /// As DescriptorPieces, the paper's K.
  constexpr int pieces = 8;
  using Measure = FeatureGraph::Measure;
  const double length = std::abs(source.Length(sourcePath) - target.Length(targetPath));
  const double msp = ProfileDistance(source.Profile(sourcePath, Measure::MSP, pieces),
    target.Profile(targetPath, Measure::MSP, pieces));
  const double agd = ProfileDistance(source.Profile(sourcePath, Measure::AGD, pieces),
    target.Profile(targetPath, Measure::AGD, pieces));
  const double end = std::abs(source.GetFeatures()[source.Head(sourcePath.back())].AGD -
    target.GetFeatures()[target.Head(targetPath.back())].AGD);
  return length + msp + 0.5 * (agd + end);
}
}
