// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_WorkingBodies_h
#define marrow_WorkingBodies_h

#include "Progress.h"
#include "WorkingSurface.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace marrow
{
/// Any mesh as the surfaces that the method runs on, and the way back to its cells.
struct WorkingBodies
{
  WorkingSurface Surface;
  std::vector<int> CellOfPolygon; ///< the input's cell that each polygon of Surface is
  int NumberOfCells = 0;          ///< of the input, vertices and lines among them

  /// One vtkPolyData per body, the largest first. A mesh that is one body and needs no mending is itself
  /// the only one, with all of its arrays.
  std::vector<vtkSmartPointer<vtkPolyData>> Meshes;
  std::vector<std::vector<int>> TrianglesOfBody; ///< of Surface, in the order of the body's cells
};

/// One sentence on what no program can use, or an empty one. What `progress` stops is left unfinished.
std::string MakeWorkingBodies(vtkPolyData* input, WorkingBodies& bodies, const Progress& progress);

/// Per body the labels of its cells, from those of the input's: what most of the area has that each became.
std::vector<std::vector<int>> LabelsOfBodies(
  const WorkingBodies& bodies, const std::vector<int>& labelOfCell);
}

#endif
