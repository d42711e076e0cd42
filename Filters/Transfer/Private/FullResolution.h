// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FullResolution_h
#define marrow_FullResolution_h

#include "WorkingSurface.h"

#include <vector>

namespace marrow
{
/// From labels of the working surface's triangles to labels of the mended mesh's triangles, which may be
/// many more. Away from boundaries a triangle takes the label of the working triangle nearest to it. Beside
/// them the labels are turned into shares at the working surface's vertices (by area) and interpolated, and
/// the largest share wins: the boundary then runs across the working triangles, as fine as the mesh is,
/// instead of round them. Where the surfaces are the same, so are the labels.
std::vector<int> LabelsAtFullResolution(
  const WorkingSurface& surface, const std::vector<int>& labelOfTriangle);

/// From triangles of the mended mesh to the polygons of the input: what most of a polygon's area has; one
/// without a triangle of its own takes that of the nearest triangle.
std::vector<int> LabelsOfPolygons(
  const WorkingSurface& surface, const std::vector<int>& labelOfFullTriangle);
}

#endif
