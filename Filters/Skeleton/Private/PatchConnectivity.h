// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PatchConnectivity_h
#define marrow_PatchConnectivity_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// Makes every patch of equal numbers connected on the mesh: of each number only the largest piece is
/// kept, and the other pieces take the number they border on most. Vertices numbered -1 count as a
/// gap: they keep -1 unless a stray piece has nothing else around it.
void JoinStrayPieces(const TriangleMesh& mesh, std::vector<int>& patchOfVertex);
}

#endif
