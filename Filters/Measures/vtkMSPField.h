// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMSPField_h
#define vtkMSPField_h

#include "MarrowMeasuresModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

/**
 * @class vtkMSPField
 * @brief average geodesic distance, minimum slice perimeter, its gradient, and dihedral angle
 *
 * Computes the measures on which skeletons, correspondences and boundaries rest:
 *
 * - AGD, average geodesic distance (correspondence paper 4.1): the area-weighted mean of the
 * geodesic distances from a vertex to all others of its component, normalised over the component to
 * [0,1]. It is small at the middle of the shape and large at its extremities. By default it is
 * taken from sampled sources, on meshes of more than 25,000 triangles along the surface simplified to
 * 20,000, which differs from all pairs by less than 0.01 in the mean.
 * - MSP, minimum slice perimeter (correspondence paper 5, transfer paper 3.4): the least perimeter
 * of the curves in which planes through the vertex and its normal cut the surface. It tells how
 * thick the part is, and its curve's centroid lies in the middle of it.
 * - The gradient of MSP (transfer paper 3.4), large where the thickness changes.
 * - The dihedral angle (transfer paper 4.4).
 *
 * Any mesh will do. One that is no clean manifold of triangles is measured on its working surface
 * (vtkWorkingSurface) at full resolution, or simplified to MaximumFaces where that is set; a clean one
 * that lies within MaximumFaces is measured as it is. The points of the input take the measures of
 * the vertices that they became or lie nearest to. Each body of the mesh is measured by itself.
 *
 * Ports: input 0 is any mesh, output 0 the same mesh, its points, cells and arrays untouched,
 * with these point arrays added or replaced:
 *
 * - AGD, double: average geodesic distance, in [0,1] per connected component; 0 throughout one where
 *   it varies by less than 2 %, as on a ball.
 * - MSP, double: least slice perimeter, in mesh units; the active scalars if the mesh has none.
 * - MSPCenter, double×3: length-weighted centroid of that slice.
 * - MSPNormal, double×3: unit normal of that slice's plane; its sign means nothing.
 * - MSPGradient, double×3: gradient of MSP, dimensionless, towards the thicker part, by the paper's
 *   sum over the edges of the triangles around the vertex: on equilateral triangles 4/√3 times the
 *   gradient proper.
 * - MSPValid, uchar: 1 where the slice is closed; 0 where it is closed by its chord, or filled in.
 * - DihedralAngle, double: mean over the vertex's inner edges, weighted by their lengths, of the angle
 *   between the normals of the two triangles; radians, convex positive, 0 where flat.
 *
 * Slices that meet a border of the mesh are followed to the border both ways and closed by the
 * chord between the ends; they count only at vertices where no slice closes by itself. Vertices
 * without any slice (no area around them) take the mean of their neighbours. Points that no face
 * uses get AGD, MSP, gradient and dihedral angle 0 and themselves as the slice centre. No value is
 * ever NaN.
 *
 * The field array WorkingSurfaceNote (a string) says what was mended; it is absent if nothing was.
 *
 * The result is the same, bit for bit, on any number of threads. It turns, moves and scales with the
 * mesh and does not depend on the order of points and cells: each body is measured in its canonical
 * frame (centroid, principal axes, root mean square radius), on whose grid rounding plays no part.
 *
 * Errors: those of vtkWorkingSurface (no face, points in use that are not finite). The message says how
 * many and where the first is.
 *
 * @sa vtkMSPSkeleton vtkWorkingSurface
 */
class MARROWMEASURES_EXPORT vtkMSPField : public vtkPolyDataAlgorithm
{
public:
  static vtkMSPField* New();
  vtkTypeMacro(vtkMSPField, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of planes tried at each vertex, from one to the next turned by π over this number. More
   * planes find a smaller perimeter and cost in proportion. Default 12, range 2 to 180.
   */
  vtkSetClampMacro(NumberOfSlices, int, 2, 180);
  vtkGetMacro(NumberOfSlices, int);
  ///@}

  /**
   * The vertices from which the average geodesic distance is taken.
   */
  enum AGDMethodType
  {
    SAMPLED = 0,  ///< from 64 farthest-point samples of each component; time grows with n
    ALL_PAIRS = 1 ///< from every vertex, as the definition says; time grows with n²
  };

  ///@{
  /**
   * From which vertices the average geodesic distance is taken. Default SAMPLED.
   */
  vtkSetClampMacro(AGDMethod, int, SAMPLED, ALL_PAIRS);
  vtkGetMacro(AGDMethod, int);
  void SetAGDMethodToSampled() { this->SetAGDMethod(SAMPLED); }
  void SetAGDMethodToAllPairs() { this->SetAGDMethod(ALL_PAIRS); }
  ///@}

  ///@{
  /**
   * A mesh of more faces than this is measured on its working surface of so many (vtkWorkingSurface), and
   * the measures are interpolated to its points. 0: every mesh is measured at every vertex.
   * Default 0, range 0 to VTK_INT_MAX.
   */
  vtkSetClampMacro(MaximumFaces, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumFaces, int);
  ///@}

protected:
  vtkMSPField() = default;
  ~vtkMSPField() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int NumberOfSlices = 12;
  int AGDMethod = SAMPLED;
  int MaximumFaces = 0;

private:
  vtkMSPField(const vtkMSPField&) = delete;
  void operator=(const vtkMSPField&) = delete;
};

#endif
