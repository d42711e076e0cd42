// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMarrowSegmentationMetrics_h
#define vtkMarrowSegmentationMetrics_h

#include "MarrowEvaluationModule.h" // for export macro
#include "vtkTableAlgorithm.h"

/**
 * @class vtkMarrowSegmentationMetrics
 * @brief how well a segmentation of a mesh agrees with a reference
 *
 * The four measures of X. Chen, A. Golovinskiy, T. Funkhouser, "A Benchmark for 3D Mesh
 * Segmentation" (2009), section 4, by the conventions of the benchmark's own evaluator, and two more.
 * The first four do not care how segments are numbered, and are 0 for equal segmentations:
 *
 * - CutDiscrepancy: mean over the vertices of both boundaries of the distance along mesh edges to
 *   the other boundary, over the average radius (mean distance of the surface from its centroid).
 * - HammingDistance: mean of MissingRate, the share of the area that each reference segment has
 *   outside of the segment that covers most of it, and FalseAlarmRate, the same the other way.
 * - RandError: 1 - Rand index, the share of the pairs of faces that are together in one of the two
 *   segmentations and apart in the other. Counts faces.
 * - GlobalConsistencyError, LocalConsistencyError (Martin et al. 2001): mean over the faces of the
 *   share of the face's segment that is outside of its segment in the other; of the two directions
 *   the lesser one as a whole, or face by face. 0 if one refines the other. Counts faces.
 * - LabelAccuracy: share of the area whose ids are equal in both; meaningful where ids are labels
 *   with the same meaning in both. 1 is best.
 * - BoundaryDistance: like CutDiscrepancy, averaged over the boundaries' length, over the diagonal
 *   of the bounding box.
 *
 * CutDiscrepancy and BoundaryDistance are 0 if neither segmentation has a boundary, and NaN if only
 * one has. On meshes of several components, boundaries on a component where the other has none do
 * not count.
 *
 * Input port 0: the segmented mesh, of any polygons; port 1: the reference, the same mesh with other ids.
 * Read of each: an integer cell array, "SegmentId" or what SetInputArrayToProcess(0, ...) and
 * SetInputArrayToProcess(1, ...) select. Geometry is taken from port 0.
 *
 * Output: a vtkTable of one row, a column (double) for each measure by its name above. The getters
 * give the same values; they are 0 until the filter has run without error.
 *
 * Errors: no face, points in use that are not finite, no area; a segment
 * array that is missing or not one value per cell; numbers of cells that differ.
 *
 * @sa vtkSegmentationTransfer
 */
class MARROWEVALUATION_EXPORT vtkMarrowSegmentationMetrics : public vtkTableAlgorithm
{
public:
  static vtkMarrowSegmentationMetrics* New();
  vtkTypeMacro(vtkMarrowSegmentationMetrics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The measures of the last update.
   */
  vtkGetMacro(CutDiscrepancy, double);
  vtkGetMacro(HammingDistance, double);
  vtkGetMacro(MissingRate, double);
  vtkGetMacro(FalseAlarmRate, double);
  vtkGetMacro(RandError, double);
  vtkGetMacro(GlobalConsistencyError, double);
  vtkGetMacro(LocalConsistencyError, double);
  vtkGetMacro(LabelAccuracy, double);
  vtkGetMacro(BoundaryDistance, double);
  ///@}

protected:
  vtkMarrowSegmentationMetrics();
  ~vtkMarrowSegmentationMetrics() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMarrowSegmentationMetrics(const vtkMarrowSegmentationMetrics&) = delete;
  void operator=(const vtkMarrowSegmentationMetrics&) = delete;

  double CutDiscrepancy = 0.0;
  double HammingDistance = 0.0;
  double MissingRate = 0.0;
  double FalseAlarmRate = 0.0;
  double RandError = 0.0;
  double GlobalConsistencyError = 0.0;
  double LocalConsistencyError = 0.0;
  double LabelAccuracy = 0.0;
  double BoundaryDistance = 0.0;
};

#endif
