// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceAnswers_h
#define marrow_SliceAnswers_h

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
}

#endif
