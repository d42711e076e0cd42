// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TournamentTree_h
#define marrow_TournamentTree_h

#include <vector>

namespace marrow
{
/// Knows the least of many values while they change, of equal ones the first. A change takes O(log n), and
/// little if it decides nothing; unlike a heap of offers that are pushed anew it holds each value once.
class TournamentTree
{
public:
  explicit TournamentTree(std::vector<double> values);

  /// The place of the least value.
  int Least() const { return this->Winners[1]; }
  double ValueAt(int place) const { return this->Values[place]; }
  void Change(int place, double value);

private:
  int WinnerOf(int node) const
  {
    const int first = this->Winners[2 * node];
    const int second = this->Winners[2 * node + 1];
    return this->Values[second] < this->Values[first] ? second : first;
  }

  std::vector<double> Values;
  std::vector<int>
    Winners; ///< per node; those of node n are 2 n and 2 n + 1, and the leaves come last
};
}

#endif
