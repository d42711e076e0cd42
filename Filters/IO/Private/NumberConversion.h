// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_NumberConversion_h
#define marrow_NumberConversion_h

#include <cmath>
#include <limits>
#include <type_traits>

namespace marrow
{
/// The number as another type; false if that cannot hold it.
template <typename To, typename From>
bool ConvertNumber(From from, To& to)
{
  if constexpr (std::is_floating_point_v<To> || std::is_same_v<To, From>)
  {
    to = static_cast<To>(from);
    return true;
  }
  else if constexpr (std::is_floating_point_v<From>)
  {
    // Beyond 2^53 not every integer is there, but then neither in the file.
    if (!(from >= static_cast<From>(std::numeric_limits<To>::min()) &&
          from < std::ldexp(From(1), std::numeric_limits<To>::digits)) ||
      from != std::floor(from))
    {
      return false;
    }
    to = static_cast<To>(from);
    return true;
  }
  else
  {
    to = static_cast<To>(from);
    return static_cast<From>(to) == from && (to < To(0)) == (from < From(0));
  }
}
}

#endif
