// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSegmentationFusion
 * @brief   makes one labelling of a mesh out of several
 *
 * Several labelled meshes carried to one target by vtkSegmentationTransfer, or several people who labelled
 * one mesh: each labelling votes on each face, and one cut settles where the boundaries run: where the votes
 * leave it open, in concave places, the more so the more the boundaries of the labellings do. Islands much
 * smaller than any piece of their segment in any of the labellings join a neighbour. On what all
 * agree, nothing is changed.
 *
 * A labelling's vote on a face counts exp(-8 c) times its confidence there, c the cost of the matching it
 * comes from. With EstimateTrust it also counts by how often it is right, which is estimated from the
 * labellings alone: what they agree on most is taken for right, and who is right more often counts more,
 * turn by turn (expectation maximization), as in S. K. Warfield, K. H. Zou, W. M. Wells, "Simultaneous
 * Truth and Performance Level Estimation (STAPLE)" (2004), here with one rate p per labelling and the
 * factor log(p (n - 1) / (1 - p)) for n segments.
 *
 * Port in, 0, repeatable: labellings of one mesh, with equal cells in equal order. Any mesh will do. Read
 * are the cell array "SegmentId" (any integers), or that set by
 * SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name), and, where they are there,
 * the cell array SegmentConfidence (double in [0,1], else 1) and the field array MatchingCost (double, else
 * 0), as vtkSegmentationTransfer writes them.
 *
 * Ports out:
 * - 0, the mesh of the first labelling with its points, cells and arrays, and the cell arrays
 *   - SegmentId (int): the segment; the only active scalars;
 *   - SegmentConfidence (double in [0,1]): the share of the votes that the segment has there, smaller near
 *     boundaries, times the mean confidence of the labellings that say so;
 *   - SegmentDisagreement (double in [0,1]): the chance that two votes on the face, drawn by their weights,
 *     differ; 0 where all agree;
 *   - SegmentShares (double, as many components as there are segments): the share of the votes of each;
 *   and the field arrays SegmentShareId (int: at i the segment of component i) and LabellingWeight
 *   (double: at i how much labelling i counts, the most 1).
 *
 * Errors, which name the labelling by its number from 0: no segment array; an array of another size, more
 * than one component, or values that are no integers; another number of cells or points than the first; no
 * face, or a point in use that is not finite; a confidence that is not finite; more than 500 segments.
 *
 * The result is the same on any number of threads, and in whatever order the labellings come, but for
 * what the first brings along beside its labels.
 *
 * @sa vtkSegmentationTransfer vtkCollectionTransfer
 */
#ifndef vtkSegmentationFusion_h
#define vtkSegmentationFusion_h

#include "MarrowCollectionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class MARROWCOLLECTION_EXPORT vtkSegmentationFusion : public vtkPolyDataAlgorithm
{
public:
  static vtkSegmentationFusion* New();
  vtkTypeMacro(vtkSegmentationFusion, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether each labelling counts by how often it is right, as estimated from all of them. Worth it from
   * three labellings on. Default off.
   */
  vtkSetMacro(EstimateTrust, bool);
  vtkGetMacro(EstimateTrust, bool);
  vtkBooleanMacro(EstimateTrust, bool);
  ///@}

protected:
  vtkSegmentationFusion();
  ~vtkSegmentationFusion() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSegmentationFusion(const vtkSegmentationFusion&) = delete;
  void operator=(const vtkSegmentationFusion&) = delete;

  bool EstimateTrust = false;
};

#endif
