// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FileMeshBridge_h
#define marrow_FileMeshBridge_h

#include "FileMesh.h"

class vtkFieldData;
class vtkPolyData;

namespace marrow
{
/// Adds arrays under their names and in their types.
void AddArrays(const std::vector<FileArray>& arrays, vtkFieldData* data);

/// Makes the mesh of a file a vtkPolyData: a polygon per face (those of
/// fewer than three corners repeat the last), the arrays under their names, and the
/// parts as the cell arrays and string arrays that vtkMarrowMeshReader names.
void ToPolyData(const FileMesh& mesh, vtkPolyData* output);

/// The polygons of a vtkPolyData, without arrays.
FileMesh ToFileMesh(vtkPolyData* input);
}

#endif
