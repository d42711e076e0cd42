// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelJobs.h"

#include <atomic>
#include <thread>
#include <vector>

namespace marrow::bench
{
void RunJobs(int count, int threads, const std::function<void(int)>& job)
{
  std::atomic<int> next{ 0 };
  const auto work = [&]
  {
    for (int i = next++; i < count; i = next++)
    {
      job(i);
    }
  };
  std::vector<std::thread> workers;
  for (int i = 1; i < threads; ++i)
  {
    workers.emplace_back(work);
  }
  work();
  for (std::thread& worker : workers)
  {
    worker.join();
  }
}
}
