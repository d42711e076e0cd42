// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_InputCheck_h
#define marrow_InputCheck_h

#include "PolygonMesh.h"

#include <string>
#include <vector>

namespace marrow
{
/// The one sentence about what no program can use: no face at all, faces that name points that do
/// not exist, points in use that are not finite. Empty where there is nothing of it.
std::string CheckInput(const PolygonMesh& input);

/// Per point: whether a polygon uses it. For a mesh that passed the check.
std::vector<char> UsedPoints(const PolygonMesh& input);
}

#endif
