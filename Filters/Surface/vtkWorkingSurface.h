// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkWorkingSurface_h
#define vtkWorkingSurface_h

#include "MarrowSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

/**
 * @class vtkWorkingSurface
 * @brief the oriented manifold on which the method runs, made of any mesh
 *
 * Mends whatever a program can mend, each by a step of its own that does nothing where nothing is to
 * do: leaves out points that no face uses; merges equal points along open edges; cuts polygons into
 * triangles, concave ones inside; leaves out faces that are there twice or have no area; parts the
 * sheets at edges of more than two faces; turns faces to agree and to look outwards, and cuts what
 * cannot be oriented; gives every fan of faces its own point; closes holes that are small against the
 * part around them (openings of tubes stay open). Then parts that touch, overlap or lie inside others
 * become one body by a wrap of the volume that they enclose together (generalized winding numbers,
 * Jacobson, Kavan and Sorkine 2013); so do soups that mending leaves in shreds. Bodies that lie apart
 * stay apart; crumbs far smaller than the largest body are left out. At last edges are collapsed
 * (quadric error metrics, Garland and Heckbert 1997) until at most MaximumFaces are left.
 *
 * A clean mesh within that size passes through bit for bit, with all its arrays.
 *
 * @section Input
 * Any vtkPolyData with polygons or triangle strips. Vertex and line cells are no surface and are
 * passed over.
 *
 * @section Output
 * Port 0: the working surface. Triangles; oriented and manifold, each connected part outwards.
 * - BodyId, int, on cells: the body a triangle belongs to, numbered from 0 by falling area.
 *
 * Port 1: the input, with
 * - WorkingTriangleId, vtkIdType, on cells: the triangle of port 0 that a face became or lies nearest
 *   to; -1 for vertex and line cells.
 * - WorkingVertexId, vtkIdType, on points: the point of port 0 that a point became or lies nearest to;
 *   -1 for points that no face uses.
 *
 * Field data of both, each a single int, 0 where nothing was to do: UnusedPoints, CutPolygons,
 * MergedPoints, FacesWithoutArea, FacesTwice, SplitEdges (of more than two faces), TurnedFaces,
 * CutEdges (of what cannot be oriented), SplitPoints (points added at pinches and parted sheets),
 * FilledHoles, LeftOutParts, UnitedParts, WrappedShreds (parts beyond mending), SimplifiedTriangles
 * (how many there were before), NumberOfOtherCells (vertices and lines); and WorkingSurfaceNote, a
 * string: what was done, in words, empty where nothing was. What was mended raises no warning.
 *
 * The result is the same, bit for bit, on any number of threads.
 *
 * Errors: no face; no face with an area; faces that name points that do not exist; points in use that
 * are not finite. The message says how many and where the first is.
 *
 * @sa vtkMSPField, vtkMSPSkeleton
 */
class MARROWSURFACE_EXPORT vtkWorkingSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkWorkingSurface* New();
  vtkTypeMacro(vtkWorkingSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Triangles that the working surface has at most; a larger mesh is simplified. A few more may be left
   * where the topology needs them. Default 30000 (at 60000 labels are
   * no better, at 20000 hands lose fingers), range 100 to VTK_INT_MAX.
   */
  vtkSetClampMacro(MaximumFaces, int, 100, VTK_INT_MAX);
  vtkGetMacro(MaximumFaces, int);
  ///@}

protected:
  vtkWorkingSurface();
  ~vtkWorkingSurface() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int MaximumFaces = 30000;

private:
  vtkWorkingSurface(const vtkWorkingSurface&) = delete;
  void operator=(const vtkWorkingSurface&) = delete;
};

#endif
