// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowSkeletonGlyphs
 * @brief   a skeleton as something to look at: tubes along the branches, balls at the feature nodes
 *
 * The input is a skeleton after the data contract (vtkPolyData, one polyline per branch, point
 * array NodeType; without NodeType only tubes are drawn). The output is a triangle surface with the
 * cell array "Color" (unsigned char, 3 components, the active scalars), to be drawn as it is;
 * vtkMarrowSkeletonMapper does so.
 *
 * ColorBy chooses the colours:
 * - NODE_TYPE: terminals blue, junctions vermilion, branches dark grey;
 * - CORRESPONDENCE: balls by the point array CorrespondenceId, tubes by the cell array
 *   BranchCorrespondenceId (what vtkSkeletonCorrespondence adds), so that matched nodes and branches
 *   of two skeletons have equal colours and what is unmatched is grey;
 * - BRANCH: tubes by the cell array BranchId, balls dark grey;
 * - LABEL: nodes by the point array LabelArrayName, and tubes by the labels of the nodes along them.
 * Ids and labels have the colours of vtkMarrowLabelColors; where the array is missing, those of NODE_TYPE.
 *
 * Sizes are fractions of the mesh's bounding-box diagonal (field array MeshDiagonal), or of the
 * skeleton's own where that is missing.
 */
#ifndef vtkMarrowSkeletonGlyphs_h
#define vtkMarrowSkeletonGlyphs_h

#include "MarrowRenderingModule.h"
#include "vtkPolyDataAlgorithm.h"

class MARROWRENDERING_EXPORT vtkMarrowSkeletonGlyphs : public vtkPolyDataAlgorithm
{
public:
  static vtkMarrowSkeletonGlyphs* New();
  vtkTypeMacro(vtkMarrowSkeletonGlyphs, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What the colours tell; see above. */
  enum ColorByEnum
  {
    NODE_TYPE = 0,
    CORRESPONDENCE = 1,
    BRANCH = 2,
    LABEL = 3
  };

  ///@{
  /** What the colours tell. Default NODE_TYPE. */
  vtkSetClampMacro(ColorBy, int, NODE_TYPE, LABEL);
  vtkGetMacro(ColorBy, int);
  ///@}

  ///@{
  /** Name of the integer point array that LABEL colours by. Default "SegmentId". */
  vtkSetStringMacro(LabelArrayName);
  vtkGetStringMacro(LabelArrayName);
  ///@}

  ///@{
  /** Small balls at the regular nodes as well, to see how densely they stand. Default off. */
  vtkSetMacro(ShowRegularNodes, bool);
  vtkGetMacro(ShowRegularNodes, bool);
  vtkBooleanMacro(ShowRegularNodes, bool);
  ///@}

  ///@{
  /** Radius of the tubes, fraction of the diagonal. Default 0.005, range [1e-4, 0.1]. */
  vtkSetClampMacro(TubeRadius, double, 1e-4, 0.1);
  vtkGetMacro(TubeRadius, double);
  ///@}

  ///@{
  /**
   * Radius of the balls, fraction of the diagonal; those of regular nodes have 0.7 of it. Default
   * 0.012, range [1e-4, 0.1].
   */
  vtkSetClampMacro(BallRadius, double, 1e-4, 0.1);
  vtkGetMacro(BallRadius, double);
  ///@}

protected:
  vtkMarrowSkeletonGlyphs();
  ~vtkMarrowSkeletonGlyphs() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMarrowSkeletonGlyphs(const vtkMarrowSkeletonGlyphs&) = delete;
  void operator=(const vtkMarrowSkeletonGlyphs&) = delete;

  int ColorBy = NODE_TYPE;
  char* LabelArrayName = nullptr;
  bool ShowRegularNodes = false;
  double TubeRadius = 0.005;
  double BallRadius = 0.012;
};

#endif
