// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentColors_h
#define marrow_SegmentColors_h

#include "FileMesh.h"

#include <map>
#include <string>
#include <vector>

namespace marrow
{
/// A colour for each label, no two the same: the one that its name says ("#rrggbb"), else that of
/// LabelPalette.h, changed a little where it is taken.
std::map<int, FileColor> ColorsOfSegments(
  const std::vector<int>& labels, const std::vector<std::string>& nameOfLabel);

/// The label that a colour of LabelPalette.h stands for, -1 for that of no label; NotAColorOfLabels for
/// other colours.
int LabelOfColor(const FileColor& color);
inline constexpr int NotAColorOfLabels = -2;
}

#endif
