// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelPalette_h
#define marrow_LabelPalette_h

#include <array>

namespace marrow
{
/// The colours of labels from 0 on, red, green and blue; vtkMarrowLabelColors says where they come from.
inline constexpr std::array<std::array<unsigned char, 3>, 24> LabelPalette = { {
  { 204, 121, 167 }, // reddish purple
  { 230, 159, 0 },   // orange
  { 86, 180, 233 },  // sky blue
  { 240, 228, 66 },  // yellow
  { 0, 158, 115 },   // bluish green
  { 213, 94, 0 },    // vermilion
  { 0, 114, 178 },   // blue
  { 17, 68, 0 },     // dark green
  { 68, 17, 153 },   // indigo
  { 34, 255, 153 },  // mint
  { 85, 0, 85 },     // plum
  { 238, 0, 85 },    // crimson
  { 102, 85, 221 },  // violet
  { 136, 68, 119 },  // mauve
  { 187, 238, 102 }, // lime
  { 85, 0, 119 },    // dark purple
  { 170, 0, 34 },    // red
  { 119, 34, 68 },   // wine
  { 153, 255, 204 }, // pale mint
  { 68, 119, 68 },   // moss
  { 187, 238, 255 }, // pale blue
  { 187, 170, 85 },  // sand
  { 187, 34, 170 },  // magenta
  { 170, 136, 255 }  // lavender
} };

/// Of what has a negative label, or none.
inline constexpr std::array<unsigned char, 3> NoLabelColor = { 204, 204, 204 };
}

#endif
