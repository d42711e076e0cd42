// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressBar.h"

#include <unistd.h>

#include <cstdio>

namespace marrow::bench
{
namespace
{
constexpr int WidthOfBar = 30;
constexpr int LinesOfFile = 20;
}

ProgressBar::ProgressBar(int total, bool shown)
  : Total(total)
  , Shown(shown && total > 0)
  , Terminal(isatty(STDERR_FILENO) != 0)
{
}

ProgressBar::~ProgressBar()
{
  if (this->Shown && this->Terminal)
  {
    std::fprintf(stderr, "\n");
  }
}

void ProgressBar::Advance(const std::string& what)
{
  ++this->Done;
  const bool dueInFile =
    this->Done * LinesOfFile / this->Total > (this->Done - 1) * LinesOfFile / this->Total;
  if (!this->Shown || !(this->Terminal || dueInFile))
  {
    return;
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->Begin;
  const int secondsLeft =
    static_cast<int>(passed.count() / this->Done * (this->Total - this->Done));
  if (this->Terminal)
  {
    std::fprintf(stderr, "\r[");
    for (int i = 0; i < WidthOfBar; ++i)
    {
      std::fputc(i * this->Total < this->Done * WidthOfBar ? '#' : '-', stderr);
    }
    std::fprintf(stderr, "] ");
  }
  std::fprintf(stderr, "%d/%d  %d:%02d left  %-28.28s%s", this->Done, this->Total, secondsLeft / 60,
    secondsLeft % 60, what.c_str(), this->Terminal ? "" : "\n");
  std::fflush(stderr);
}
}
