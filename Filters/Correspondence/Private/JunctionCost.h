// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_JunctionCost_h
#define marrow_JunctionCost_h

#include "FeatureGraph.h"

#include <vector>

namespace marrow
{
/// ε of the correspondence paper: keeps a product of costs from becoming zero.
inline constexpr double CostEpsilon = 0.01;

/// C_struct (correspondence paper, equation 2) of two lists of sub-skeleton sizes in any order.
double StructureCost(std::vector<double> sourceSizes, std::vector<double> targetSizes);

/// C_struct of two groups.
double StructureCost(const FeatureGraph& source, const FeatureGroup& sourceGroup,
  const FeatureGraph& target, const FeatureGroup& targetGroup);

/// C_junc = (C_center + ε)(C_struct + ε) of two groups (correspondence paper, equation 3).
double JunctionCost(const FeatureGraph& source, const FeatureGroup& sourceGroup,
  const FeatureGraph& target, const FeatureGroup& targetGroup);

/// The single junctions of a component and what merging makes of them: for each junction, the
/// groups that grow from it over branches to other junctions no longer than `mergeDistance` (in
/// mesh units), the shortest first, up to `maximumSize` junctions. Every group once, in ascending
/// order of size.
std::vector<FeatureGroup> JunctionGroups(
  const FeatureGraph& graph, int component, double mergeDistance, int maximumSize);

/// The groups that grow from one junction, itself first. Features for which `blocked` is true stay
/// out.
std::vector<FeatureGroup> GroupsFrom(const FeatureGraph& graph, int feature, double mergeDistance,
  int maximumSize, const std::vector<bool>& blocked);
}

#endif
