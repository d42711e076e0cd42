// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BinaryScale_h
#define marrow_BinaryScale_h

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace marrow
{
/// Powers of areas and volumes leave the range of doubles beyond about 2^±170. The exponent of the power of
/// two that takes the largest coordinate of the points (with the numbers `used`) back near 1, and changes no
/// digit; 0 where they are far from that range.
inline int ScaleExponent(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& used)
{
  /// Beyond 2 to this, products of six coordinates leave the range of a double.
  constexpr int largestExponent = 64;
  double largest = 0.0;
  for (int point : used)
  {
    largest = std::max(largest, points[point].cwiseAbs().maxCoeff());
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::abs(exponent) > largestExponent ? exponent : 0;
}

/// Multiplies by 2^exponent.
inline void Scale(Eigen::Vector3d& point, int exponent)
{
  for (int k = 0; exponent != 0 && k < 3; ++k)
  {
    point[k] = std::ldexp(point[k], exponent);
  }
}

inline void Scale(std::vector<Eigen::Vector3d>& points, int exponent)
{
  for (Eigen::Vector3d& point : points)
  {
    Scale(point, exponent);
  }
}
}

#endif
