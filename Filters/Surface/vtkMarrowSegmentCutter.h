// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowSegmentCutter
 * @brief   Cuts a labelled mesh along smooth boundaries of its segments
 *
 * Labels of whole faces have boundaries that run in steps along the edges. Here the faces that a boundary
 * crosses are cut, so that it is a smooth line as a person would draw it: for pictures, for 3D printing in
 * parts, for measuring lengths and areas. The line stays within some two faces of where the labels change.
 *
 * Each vertex has shares of the segments, by the areas of its faces, smoothed a few times over the edges;
 * a boundary runs where two shares are equal, linearly interpolated (marching triangles for several
 * labels, as in the discrete marching cubes of volumes). All other faces stay as they are: polygons stay
 * polygons, and the points of the input keep their numbers.
 *
 * Input: a mesh (polygons, triangle strips) with its segments in the cell array SegmentId (any integers), or
 * that set by SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name).
 *
 * Output: the mesh, cut, in place of each face that was cut its pieces. The faces on both sides of a
 * boundary share its points.
 *
 * | array | on | type | meaning |
 * | --- | --- | --- | --- |
 * | SegmentId | cells | int | the segment of the piece |
 * | vtkOriginalCellIds | cells | vtkIdType | the cell of the input that it is of |
 * | all others | cells | | those of that cell |
 * | all | points | | those of the input; on a boundary interpolated |
 *
 * A segment too small to have the most of any vertex keeps its faces as they are. Vertex and line cells
 * are left out.
 *
 * Errors: no segments (the message names the cell arrays there are), or not whole numbers in the range of an
 * int; no face; a point in use that is not finite.
 *
 * @sa vtkSegmentationTransfer vtkSegmentationFusion
 */
#ifndef vtkMarrowSegmentCutter_h
#define vtkMarrowSegmentCutter_h

#include "MarrowSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class MARROWSURFACE_EXPORT vtkMarrowSegmentCutter : public vtkPolyDataAlgorithm
{
public:
  static vtkMarrowSegmentCutter* New();
  vtkTypeMacro(vtkMarrowSegmentCutter, vtkPolyDataAlgorithm);

protected:
  vtkMarrowSegmentCutter();
  ~vtkMarrowSegmentCutter() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMarrowSegmentCutter(const vtkMarrowSegmentCutter&) = delete;
  void operator=(const vtkMarrowSegmentCutter&) = delete;
};

#endif
