// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_WeightedMedian_h
#define marrow_WeightedMedian_h

#include <algorithm>
#include <utility>
#include <vector>

namespace marrow
{
/// Of values with their weights: the value below and above which half of the weights lie; 0 of none.
inline double WeightedMedian(std::vector<std::pair<double, double>> values)
{
  std::sort(values.begin(), values.end());
  double total = 0.0;
  for (const auto& entry : values)
  {
    total += entry.second;
  }
  double below = 0.0;
  for (const auto& [value, weight] : values)
  {
    below += weight;
    if (2.0 * below >= total)
    {
      return value;
    }
  }
  return 0.0;
}
}

#endif
