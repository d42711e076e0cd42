// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceBridge_h
#define marrow_SurfaceBridge_h

#include "PolygonMesh.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace marrow
{
/// The faces of a vtkPolyData: its polygons, and of a triangle strip each triangle. Point i is point i.
struct SurfaceOfPolyData
{
  PolygonMesh Mesh;
  std::vector<int> CellOfPolygon;
  std::vector<int> PolygonOfCell; ///< the first of a strip; -1 for vertex and line cells
  int NumberOfOtherCells = 0;     ///< vertices and lines, which are no surface
};

/// Copies the faces. Point ids that do not exist are copied as -1.
SurfaceOfPolyData ToPolygonMesh(vtkPolyData* input);

/// Says in the field data what was mended: the array WorkingSurfaceNote.
void SetNote(const std::string& sentence, vtkPolyData* output);
}

#endif
