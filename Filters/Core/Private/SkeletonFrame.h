// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonFrame_h
#define marrow_SkeletonFrame_h

#include "CanonicalFrame.h"
#include "Skeleton.h"

namespace marrow
{
/// The skeleton as seen from `frame`, on its grid.
Skeleton ToFrame(Skeleton skeleton, const CanonicalFrame& frame);

/// The way back: a skeleton that was on the grid is the same after both.
Skeleton FromFrame(Skeleton skeleton, const CanonicalFrame& frame);

/// The frame of the skeleton itself: its nodes, each with the length of skeleton that is nearest to it.
CanonicalFrame FrameOf(const Skeleton& skeleton);
}

#endif
