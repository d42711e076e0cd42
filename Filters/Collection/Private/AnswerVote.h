// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnswerVote_h
#define marrow_AnswerVote_h

#include "CollectionGraph.h"
#include "Progress.h"

namespace marrow
{
/// Chooses the answer of every link of a graph anew: that which agrees best with the rest.
///
/// The labels spread over the coarse meshes by the answers that the surfaces alone support best. Then, at
/// every end of a link that is to be told, each answer's labels are compared with what all other tellers
/// say together; what differs, as a share of the area, is one more thing that speaks against the answer,
/// beside those of Evidence, and counts like them. Two fingers that are exchanged between two hands are so
/// put right by the other hands. This is done twice, as the first choice changes what the rest says.
///
/// False if `progress` asked to stop.
bool VoteOnAnswers(CollectionGraph& graph, const Progress& progress);
}

#endif
