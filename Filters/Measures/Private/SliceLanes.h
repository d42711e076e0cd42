// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceLanes_h
#define marrow_SliceLanes_h

#include "SliceTracer.h"
#include "VectorUnits.h"

#include <functional>

namespace marrow
{
/// Number of curves that FollowInLanes follows at once.
constexpr int SliceLaneCount = 16;

/// Follows many curves at once, one in each lane, with the same bits as SliceWalker, which a lane's
/// arithmetic repeats operation by operation. A walk by itself waits for memory and for branches that
/// no processor can foretell; in lanes there are none, and the waits overlap.
///
/// `nextCurve(lane)` is called for every lane at the start and again when the curve that it returned
/// has been followed; a lane for which it returns nullptr rests from then on.
void FollowInLanes(const SliceMesh& mesh, const std::function<SliceCurve*(int lane)>& nextCurve,
  VectorUnits units = WidestVectorUnits());
}

#endif
