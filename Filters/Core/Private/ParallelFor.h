// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ParallelFor_h
#define marrow_ParallelFor_h

#include <functional>

namespace marrow
{
/// Calls `body(first, last)` on disjoint sub-ranges that cover [begin, end), on the threads of
/// vtkSMPTools. A body writes only to places of its own range, so that the result is the same on any
/// number of threads.
void ParallelFor(int begin, int end, const std::function<void(int first, int last)>& body);
}

#endif
