// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FusedSurface_h
#define marrow_FusedSurface_h

#include "LabelVotes.h"
#include "PreparedSurface.h"
#include "Progress.h"
#include "SideTransfer.h"

#include <vector>

namespace marrow
{
/// The area of each cell of the input; 0 for vertices and lines.
std::vector<double> AreaOfCells(const PreparedSurface& surface);

/// One labelling of a mesh made of the votes on its cells, by one cut for each body. On what all labellings
/// agree, nothing is changed. What `progress` stops is left unfinished.
CellLabels FuseOnSurface(const PreparedSurface& surface, const LabelVotes& votes,
  const std::vector<Labelling>& labellings, const Progress& progress);
}

#endif
