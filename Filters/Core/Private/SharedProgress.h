// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SharedProgress_h
#define marrow_SharedProgress_h

#include "Progress.h"

#include <mutex>
#include <thread>

namespace marrow
{
/// Progress of work that several threads do together. The thread that makes it reports for all, in the
/// midst of its own share; where it has none (VTK's STDThread backend), between the parallel loops.
class SharedProgress
{
public:
  explicit SharedProgress(const Progress& progress)
    : Outward(progress)
    , Reporter(std::this_thread::get_id())
  {
  }

  /// Called by any thread when it has done the next `share` of the whole, 1. False when the user asked
  /// to stop: the thread then returns at once.
  bool Add(double share)
  {
    double done = 0.0;
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      this->Done += share;
      done = this->Done;
      if (this->Stopped || std::this_thread::get_id() != this->Reporter)
      {
        return !this->Stopped;
      }
    }
    // Unlocked: what is called may take its time.
    const bool goOn = Report(this->Outward, done < 1.0 ? done : 1.0);
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Stopped = !goOn;
    return goOn;
  }

private:
  Progress Outward;
  std::thread::id Reporter;
  std::mutex Guard;
  double Done = 0.0;
  bool Stopped = false;
};
}

#endif
