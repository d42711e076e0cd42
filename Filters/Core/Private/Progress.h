// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Progress_h
#define marrow_Progress_h

#include <functional>

namespace marrow
{
/// Called by an algorithm, always from the thread that started it, with the fraction done in [0,1].
/// Returns false when the user asked to stop: the algorithm then returns at once, its result unused.
/// An empty function means that nobody watches.
using Progress = std::function<bool(double)>;

/// Reports to `progress` if there is one; true means go on.
inline bool Report(const Progress& progress, double fraction)
{
  return !progress || progress(fraction);
}

/// A callback for one part of a longer job: 0 maps to `from`, 1 to `to`.
inline Progress SubProgress(const Progress& progress, double from, double to)
{
  if (!progress)
  {
    return {};
  }
  return [=](double fraction) { return progress(from + (to - from) * fraction); };
}
}

#endif
