// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowSegmentSelector
 * @brief   make segments of the labels that a mesh brings along, whatever form they have
 *
 * Input port 0: a mesh, vtkPolyData. Labels names what its segments are, the first of these that is
 * there:
 * - a cell array of that name, of one whole number per cell in the range of an int, whatever its type;
 * - a point array of that name, of the same kind: a cell has the label of most of its corners, of several
 *   labels as frequent the least;
 * - "groups", "objects" or "materials": the cell array GroupId, ObjectId or MaterialId, as
 *   vtkMarrowMeshReader makes them from the parts of a file;
 * - "colors": equal colours are one segment. Those of the cells, Colors or else the active scalars if
 *   these are unsigned char x 3 or 4; else those of the points, by their cells' corners as above. Colours
 *   that are all among those of vtkMarrowLabelColors stand for its labels; others are numbered from 0 in the
 *   order of their red, green, blue and opacity.
 *
 * Output port 0: the same mesh, and
 * - cells, SegmentId (int), the only active scalars;
 * - field data, SegmentName (string), where segments have names: at i the name of segment i, which is
 *   that of a group, object or material, or a colour as "#rrggbb".
 *
 * Errors: there is nothing of that name, and what there is instead; the array is not of the kind above;
 * a cell without corners has no label in a point array.
 */
#ifndef vtkMarrowSegmentSelector_h
#define vtkMarrowSegmentSelector_h

#include "MarrowIOModule.h"

#include <vtkPolyDataAlgorithm.h>

class MARROWIO_EXPORT vtkMarrowSegmentSelector : public vtkPolyDataAlgorithm
{
public:
  static vtkMarrowSegmentSelector* New();
  vtkTypeMacro(vtkMarrowSegmentSelector, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What the segments are. Default: "SegmentId".
   */
  vtkSetStringMacro(Labels);
  vtkGetStringMacro(Labels);
  ///@}

protected:
  vtkMarrowSegmentSelector();
  ~vtkMarrowSegmentSelector() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* Labels = nullptr;

private:
  vtkMarrowSegmentSelector(const vtkMarrowSegmentSelector&) = delete;
  void operator=(const vtkMarrowSegmentSelector&) = delete;
};

#endif
