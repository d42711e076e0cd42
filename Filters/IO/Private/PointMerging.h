// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PointMerging_h
#define marrow_PointMerging_h

#include "FileMesh.h"

namespace marrow
{
/// Makes points of exactly equal coordinates one, in the order in which they come first. Points with
/// coordinates that are not finite stay apart.
void MergeEqualPoints(FileMesh& mesh);
}

#endif
