// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelCleanUp_h
#define marrow_LabelCleanUp_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// Makes every piece one connected region again: of each piece the largest component is kept, every
/// other one joins the neighbour along the longest common border.
void KeepLargestComponents(const TriangleMesh& mesh, std::vector<int>& pieceOfTriangle);
}

#endif
