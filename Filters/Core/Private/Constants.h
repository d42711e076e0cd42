// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Constants_h
#define marrow_Constants_h

namespace marrow
{
inline constexpr double Pi = 3.14159265358979323846;
}

#endif
