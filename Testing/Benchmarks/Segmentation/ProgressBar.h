// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ProgressBar_h
#define marrow_ProgressBar_h

#include <chrono>
#include <string>

namespace marrow::bench
{
/// Jobs done, what is being done, and the time left: one line of a terminal that is rewritten, or a
/// line for every twentieth part where stderr is no terminal.
class ProgressBar
{
public:
  ProgressBar(int total, bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Advance(const std::string& what);

private:
  int Total;
  bool Shown;
  bool Terminal;
  int Done = 0;
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};
}

#endif
