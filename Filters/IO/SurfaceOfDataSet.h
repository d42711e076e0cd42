// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceOfDataSet_h
#define marrow_SurfaceOfDataSet_h

class vtkDataSet;
class vtkPolyData;

namespace marrow
{
/// The polygons of any data set: those of a surface as they are, in their order, triangle strips as
/// their triangles, cells with curved edges by their corners; of a volume its outer surface. Polygons of one or two corners repeat the last,
/// as a vtkPolyData holds none of them. Vertices and lines are left out. Points and all arrays are kept.
void ToSurface(vtkDataSet* data, vtkPolyData* surface);
}

#endif
