// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PartRelations_h
#define marrow_PartRelations_h

#include "Progress.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// What the connected parts of a mesh are to one another.
struct PartRelations
{
  std::vector<int> PartOfTriangle; ///< numbered from 0, the part of most area first
  int NumberOfParts = 0;
  std::vector<char> IsLeftOut; ///< per part: lies inside another, or is a crumb
  std::vector<int> Group; ///< per part: the lowest of the parts that it touches or overlaps, and
                          ///< so on; itself for one apart from the others and one left out
  bool IsShreds = false;  ///< the parts are pieces of a surface rather than bodies
};

/// A part is a crumb if less than `leastShare` of the area of the largest is in it, and inside another
/// if that winds around its points. Parts touch if they cross, or if they meet, up to the rounding of
/// single precision, over more than `resolution`: a point in common does not join them. The mesh is in
/// shreds if the crumbs outweigh the bodies, if a band of width `resolution` along all borders would
/// cover a quarter of it, or if more pairs of parts meet than there are triangles. False if aborted.
bool RelateParts(const TriangleMesh& mesh, double leastShare, double resolution,
  const Progress& progress, PartRelations& relations);
}

#endif
