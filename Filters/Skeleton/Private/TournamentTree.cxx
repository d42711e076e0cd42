// SPDX-License-Identifier: BSD-3-Clause
#include "TournamentTree.h"

#include <limits>
#include <numeric>
#include <utility>

namespace marrow
{
TournamentTree::TournamentTree(std::vector<double> values)
  : Values(std::move(values))
{
  std::size_t size = 2;
  while (size < this->Values.size())
  {
    size *= 2;
  }
  this->Values.resize(size, std::numeric_limits<double>::infinity());
  this->Winners.resize(2 * size);
  std::iota(this->Winners.begin() + size, this->Winners.end(), 0);
  for (int node = static_cast<int>(size); --node > 0;)
  {
    this->Winners[node] = this->WinnerOf(node);
  }
}

void TournamentTree::Change(int place, double value)
{
  this->Values[place] = value;
  for (int node = (place + static_cast<int>(this->Values.size())) / 2; node > 0; node /= 2)
  {
    const int before = this->Winners[node];
    this->Winners[node] = this->WinnerOf(node);
    if (this->Winners[node] == before && before != place)
    {
      return;
    }
  }
}
}
