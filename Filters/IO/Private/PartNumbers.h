// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PartNumbers_h
#define marrow_PartNumbers_h

#include "FileMesh.h"

#include <string>
#include <vector>

namespace marrow
{
/// Segment numbers for parts that have names.
struct NumberedParts
{
  std::vector<int> IdOfPart; ///< of each part that was given
  std::vector<std::string>
    NameOfId; ///< empty where no part has the number, or its name is NameOfSegment
};

/// Numbers that depend on nothing but the names, so that two files agree: the number at the end of each
/// name where all names are the same before it ("leg1", "leg2"; "3", "7"), else the place in the
/// alphabet, from 0.
NumberedParts NumberParts(const std::vector<std::string>& names);

/// The same for colours: the label where all are colours of labels (LabelPalette.h), else the place in
/// the order of red, green, blue and opacity, from 0.
NumberedParts NumberColors(const std::vector<FileColor>& colors);

/// What a segment is called that has no name: "segment_3".
std::string NameOfSegment(int id);

/// "#rrggbb", followed by the opacity if that is not full.
std::string NameOfColor(const FileColor& color);
/// The other way; false if it is no such name.
bool ColorOfName(const std::string& name, FileColor& color);

/// The most frequent one; of several the least.
int MostFrequent(std::vector<int> labels);
}

#endif
