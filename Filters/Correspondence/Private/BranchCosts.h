// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BranchCosts_h
#define marrow_BranchCosts_h

#include "FeatureCorrespondence.h"

namespace marrow
{
/// Adds C_branch of every pair of nodes at which two or more branches are matched.
void AddBranchCosts(
  FeatureCorrespondence& match, const FeatureGraph& source, const FeatureGraph& target);
}

#endif
