// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_OtherAnswers_h
#define marrow_OtherAnswers_h

#include "AnalyzedMesh.h"
#include "AnswerChoice.h"

#include <vector>

namespace marrow
{
/// Where both meshes are surfaces of revolution whose profiles agree more than they differ, puts two
/// answers by slices before those of the skeletons: one way round and the other, the cheaper first.
/// The skeletons, hardly more than straight lines that match in any case, then count for as much as if
/// nothing were matched. At most MostAnswers are kept.
void PreferSlices(
  const AnalyzedMesh& source, const AnalyzedMesh& target, std::vector<Answer>& answers);

/// Adds the answer that matches nothing, for a bust or a machine part, of which the skeletons say little; not where
/// there are answers by slices. It costs hardly more than the first: the surfaces decide.
void AddWhole(const AnalyzedMesh& source, const AnalyzedMesh& target, std::vector<Answer>& answers);
}

#endif
