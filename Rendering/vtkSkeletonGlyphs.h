// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkeletonGlyphs
 * @brief   a skeleton as something to look at: tubes along the branches, balls at the feature nodes
 *
 * The input is a skeleton after the data contract (vtkPolyData, one polyline per branch, point
 * array NodeType; without NodeType only tubes are drawn). The output is a triangle surface with the
 * cell array "Color" (unsigned char, 3 components, the active scalars), to be drawn as it is.
 *
 * ColorBy chooses the colours:
 * - NODE_TYPE: terminals blue, junctions vermilion, branches dark grey;
 * - CORRESPONDENCE: balls by the point array CorrespondenceId, tubes by the cell array
 *   BranchCorrespondenceId (what vtkSkeletonCorrespondence adds) in the colours of vtkLabelColors,
 * so that matched nodes and branches of two skeletons have equal colours; what is unmatched is
 * grey.
 *
 * Sizes are fractions of the mesh's bounding-box diagonal (field array MeshDiagonal), or of the
 * skeleton's own where that is missing.
 */
#ifndef vtkSkeletonGlyphs_h
#define vtkSkeletonGlyphs_h

#include "MarrowRenderingModule.h"
#include "vtkPolyDataAlgorithm.h"

class MARROWRENDERING_EXPORT vtkSkeletonGlyphs : public vtkPolyDataAlgorithm
{
public:
  static vtkSkeletonGlyphs* New();
  vtkTypeMacro(vtkSkeletonGlyphs, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ColorByEnum
  {
    NODE_TYPE = 0,
    CORRESPONDENCE = 1
  };

  ///@{
  /** What the colours tell. Default NODE_TYPE. */
  vtkSetClampMacro(ColorBy, int, NODE_TYPE, CORRESPONDENCE);
  vtkGetMacro(ColorBy, int);
  ///@}

  ///@{
  /** Radius of the tubes, fraction of the diagonal. Default 0.005, range [1e-4, 0.1]. */
  vtkSetClampMacro(TubeRadius, double, 1e-4, 0.1);
  vtkGetMacro(TubeRadius, double);
  ///@}

  ///@{
  /** Radius of the balls, fraction of the diagonal. Default 0.012, range [1e-4, 0.1]. */
  vtkSetClampMacro(BallRadius, double, 1e-4, 0.1);
  vtkGetMacro(BallRadius, double);
  ///@}

protected:
  vtkSkeletonGlyphs() = default;
  ~vtkSkeletonGlyphs() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSkeletonGlyphs(const vtkSkeletonGlyphs&) = delete;
  void operator=(const vtkSkeletonGlyphs&) = delete;

  int ColorBy = NODE_TYPE;
  double TubeRadius = 0.005;
  double BallRadius = 0.012;
};

#endif
