// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMarrowMeanCurvatureSkeleton_h
#define vtkMarrowMeanCurvatureSkeleton_h

#include "MarrowSkeletonCGALModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

/**
 * @class vtkMarrowMeanCurvatureSkeleton
 * @brief CGAL's mean curvature flow skeleton of a mesh, and φ: the baseline for vtkMSPSkeleton
 *
 * The surface is contracted by its mean curvature flow, drawn to the medial axis, until it is a thin
 * thread, which is collapsed to a curve: A. Tagliasacchi, I. Alhashim, M. Olson, H. Zhang, "Mean
 * Curvature Skeletons" (2012), the modern form of the skeleton that the correspondence paper and the
 * transfer paper compare theirs with (Au et al. 2008). Everything is left as CGAL gives it: no spur
 * is pruned and no node moved, so nodes may lie outside the surface and the number of terminals
 * depends on the resolution. Use it for comparisons, and vtkMSPSkeleton for work.
 *
 * Ports and arrays are those of vtkMSPSkeleton, so the one can stand for the other in front of
 * vtkSkeletonCorrespondence and vtkSegmentationTransfer.
 *
 * Input port 0: a mesh whose working surface (vtkWorkingSurface, at full resolution) is closed, with the
 * point arrays AGD, MSP, MSPCenter and MSPValid of vtkMSPField; where one of them is missing, they are
 * computed with that filter's defaults. The contraction itself reads the positions only, and is run on
 * each body.
 *
 * Output port 0: the skeleton. Points are nodes, in double; cells are polylines, one for each branch
 * between two feature nodes (terminals, junctions); a cycle without one is a closed polyline.
 *
 * | array | on | type | meaning |
 * | --- | --- | --- | --- |
 * | NodeType | points | int | 1 terminal, 2 regular, 3 junction |
 * | Radius | points | double | mean distance from the node to its φ, mesh units |
 * | AGD, MSP | points | double | means over φ; of the neighbouring nodes where φ is empty |
 * | VertexCount | points | vtkIdType | size of φ, 0 for a node that only vertices of CGAL's own made |
 * | BranchId | cells | vtkIdType | number of the branch |
 * | BranchLength | cells | double | arc length, mesh units |
 * | MeshDiagonal, MeshMaximumMSP | field | double | of the mesh, mesh units |
 *
 * Output port 1: the input mesh, points and cells and arrays as they were, the arrays of vtkMSPField,
 * and the point array SkeletonNodeId (vtkIdType): the skeleton point whose φ holds the vertex, -1 for
 * points that no face uses.
 *
 * The number of loops of the skeleton is the genus of the mesh in general, but CGAL does not promise
 * it: handles of few triangles and short tunnels are lost. The result is the same in every run:
 * where CGAL (before 6.0) collapses edges in the order of their addresses in memory, they are put in
 * the order of their numbers. An abort is looked for between the steps of the contraction.
 *
 * Errors: those of vtkMSPField; a mesh with an opening that is no small hole; measures that
 * are there but not finite; a mesh on which the contraction does not end in a curve. The skeleton is
 * then empty.
 *
 * Licence: this module compiles parts of CGAL that are under the GPL (version 3 or later). Marrow's
 * own code keeps its licence, but the library MarrowSkeletonCGAL and every program that links it are
 * under the GPL, unless you have a commercial licence of CGAL. No other module of Marrow links it;
 * it is not built without CGAL or with MARROW_USE_CGAL off.
 *
 * @sa vtkMSPSkeleton vtkMSPField vtkSkeletonCorrespondence
 */
class MARROWSKELETONCGAL_EXPORT vtkMarrowMeanCurvatureSkeleton : public vtkPolyDataAlgorithm
{
public:
  static vtkMarrowMeanCurvatureSkeleton* New();
  vtkTypeMacro(vtkMarrowMeanCurvatureSkeleton, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How slowly the surface contracts (CGAL's quality_speed_tradeoff, the paper's w_H): smaller is
   * faster and coarser. Default 0.1 as in CGAL, range 0.001 to 100, a ratio.
   */
  vtkSetClampMacro(QualitySpeedTradeoff, double, 0.001, 100.0);
  vtkGetMacro(QualitySpeedTradeoff, double);
  ///@}

  ///@{
  /**
   * How strongly the surface is drawn to the medial axis (CGAL's medially_centered_speed_tradeoff,
   * the paper's w_M): larger is closer to it, less smooth and slower; 0 leaves the medial axis out.
   * Default 0.2 as in CGAL, range 0 to 100, a ratio.
   */
  vtkSetClampMacro(MediallyCenteredSpeedTradeoff, double, 0.0, 100.0);
  vtkGetMacro(MediallyCenteredSpeedTradeoff, double);
  ///@}

protected:
  vtkMarrowMeanCurvatureSkeleton();
  ~vtkMarrowMeanCurvatureSkeleton() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double QualitySpeedTradeoff = 0.1;
  double MediallyCenteredSpeedTradeoff = 0.2;

private:
  vtkMarrowMeanCurvatureSkeleton(const vtkMarrowMeanCurvatureSkeleton&) = delete;
  void operator=(const vtkMarrowMeanCurvatureSkeleton&) = delete;
};

#endif
