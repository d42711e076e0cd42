// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMSPSkeleton_h
#define vtkMSPSkeleton_h

#include "MarrowSkeletonModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

/**
 * @class vtkMSPSkeleton
 * @brief curve skeleton of a mesh from its minimum slice perimeters, and φ
 *
 * The skeleton of the correspondence paper, section 5: every vertex moves to the centre of its least
 * slice, the shrunk mesh is collapsed edge by edge until no triangle is left, and the vertices that
 * were merged into a node are its φ. Every step runs on real meshes without user interaction:
 *
 * - Where no plane cuts across the part (tips, flat feet, joints) the slice centre is unreliable. It is
 *   recognized by its perimeter, which cannot grow faster along the surface than on a cone. Unreliable
 *   vertices are smoothed towards their neighbours, over a length in proportion to the local thickness.
 * - The number of independent loops of the skeleton is the genus of the mesh, by construction: the
 *   collapse keeps track of the homology of the surface and closes only the loops around tubes.
 * - Spurs are distinguished from limbs by prominence (length over thickness) and share of the area; the cut
 *   is made in the widest gap of the two. The vertices of a spur count for the node where it hung (for
 *   its φ and all means over φ), but not for where the nodes stand.
 * - Regular nodes are evened out, stand in the middle of their ring, inside the surface; terminals
 *   reach for the tip.
 *
 * Input port 0: any mesh, with the point arrays AGD, MSP, MSPCenter and MSPValid of vtkMSPField; where
 * one of them is missing, they are computed with that filter's defaults. The skeleton is that of the
 * working surface (vtkWorkingSurface), a skeleton for each of its bodies. The mesh may be open: a border
 * is treated as if it were closed by a fan.
 *
 * Output port 0: the skeleton. Points are nodes, in double; cells are polylines, one for each branch
 * between two feature nodes (terminals, junctions); a cycle without one is a closed polyline.
 *
 * | array | on | type | meaning |
 * | --- | --- | --- | --- |
 * | NodeType | points | int | 1 terminal, 2 regular, 3 junction |
 * | Radius | points | double | mean distance from the node to its φ, mesh units |
 * | AGD, MSP | points | double | means over φ |
 * | VertexCount | points | vtkIdType | size of φ |
 * | BranchId | cells | vtkIdType | number of the branch |
 * | BranchLength | cells | double | arc length, mesh units |
 * | MeshDiagonal, MeshMaximumMSP | field | double | of the mesh, mesh units |
 *
 * Output port 1: the input mesh, points and cells and arrays as they were, the arrays of vtkMSPField,
 * and the point array SkeletonNodeId (vtkIdType): the skeleton point whose φ holds the vertex that the
 * point became or lies nearest to; -1 for points that no face uses. The field array WorkingSurfaceNote
 * (a string) says what was mended; it is absent if nothing was.
 *
 * Errors: those of vtkMSPField; the outputs are then empty. A mesh whose measures are there but not
 * finite is an error that names the array and the point.
 *
 * @sa vtkMSPField vtkSkeletonCorrespondence vtkWorkingSurface
 */
class MARROWSKELETON_EXPORT vtkMSPSkeleton : public vtkPolyDataAlgorithm
{
public:
  static vtkMSPSkeleton* New();
  vtkTypeMacro(vtkMSPSkeleton, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The share of the surface area from which a limb gets a branch of its own; what is clearly
   * smaller is a spur. Lower it to have fingers and toes, raise it for the rough form only.
   * Default 0.004, range 0 to 1, a ratio.
   */
  vtkSetClampMacro(FinestArea, double, 0.0, 1.0);
  vtkGetMacro(FinestArea, double);
  ///@}

  ///@{
  /**
   * Distance of the nodes along a branch, over the diagonal of the bounding box. On a coarse mesh it
   * is widened so that a node has eight vertices on average. Default 0.012, range 0.001 to 0.5.
   */
  vtkSetClampMacro(NodeSpacing, double, 0.001, 0.5);
  vtkGetMacro(NodeSpacing, double);
  ///@}

  ///@{
  /**
   * The most faces of the working surface on which the skeleton is made: finer meshes are simplified to
   * so many first. 0: never. Default 30000, range 0 to VTK_INT_MAX.
   */
  vtkSetClampMacro(MaximumFaces, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumFaces, int);
  ///@}

protected:
  vtkMSPSkeleton();
  ~vtkMSPSkeleton() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double FinestArea = 0.004;
  double NodeSpacing = 0.012;
  int MaximumFaces = 30000;

private:
  vtkMSPSkeleton(const vtkMSPSkeleton&) = delete;
  void operator=(const vtkMSPSkeleton&) = delete;
};

#endif
