// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ParallelJobs_h
#define marrow_ParallelJobs_h

#include <functional>

namespace marrow::bench
{
/// Calls job(i) for every i below `count` on `threads` threads, which take the next i when they are
/// done with one: pairs differ in how long they take. The job must not throw.
void RunJobs(int count, int threads, const std::function<void(int)>& job);
}

#endif
