// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Thumbnails_h
#define marrow_Thumbnails_h

#include "ResultTable.h"

#include <string>

namespace marrow::bench
{
/// Whether pictures can be drawn: VTK of most packages needs an X display and aborts without.
bool CanDraw();

/// Draws the target as it should be, the source and the target as it came out, in the colours of
/// the semantic labels, as a PNG file in the result folder's subfolder thumbnails; returns its path.
/// Throws std::runtime_error.
std::string DrawThumbnail(
  const std::string& dataFolder, const std::string& resultFolder, const Result& pair);
}

#endif
