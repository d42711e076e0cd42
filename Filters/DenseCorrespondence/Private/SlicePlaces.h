// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SlicePlaces_h
#define marrow_SlicePlaces_h

#include "AnalyzedMesh.h"
#include "SliceAlignment.h"
#include "SourceSearch.h"

#include <vector>

namespace marrow
{
/// Per vertex of `target` its place on the source by slices, the target turned about the axis so that
/// its handles and spouts come closest to those of the source. What stands off the wall is found among
/// what stands off it, if there is any, and the wall on the wall. `search` is that of the source.
std::vector<SourceSearch::Query> PlacesBySlices(const AnalyzedMesh& source,
  const TriangleMesh& target, SliceAlignment alignment, const SourceSearch& search);
}

#endif
