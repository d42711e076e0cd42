// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowLabelColors
 * @brief   categorical colours that depend on nothing but the label
 *
 * Equal labels have equal colours on every mesh, whatever other labels are there, so that pictures
 * of a source and of its targets can be compared by eye. There are 24 colours, then they repeat.
 * Negative labels (-1: unmatched, unlabelled) are light grey.
 *
 * People with colour-deficient vision tell them apart: any two differ by at least 16 (the first
 * twelve) or 14 (all) in CIE Lab, as seen by anybody or with protanopia, deuteranopia or tritanopia
 * (Machado, Oliveira and Fernandes 2009). The first seven are those of Okabe and Ito 2008 without
 * black; the others were found by maximizing the least difference, the label's grey included.
 */
#ifndef vtkMarrowLabelColors_h
#define vtkMarrowLabelColors_h

#include "MarrowRenderingModule.h"
#include "vtkObject.h"

class vtkDataArray;
class vtkLookupTable;

class MARROWRENDERING_EXPORT vtkMarrowLabelColors : public vtkObject
{
public:
  static vtkMarrowLabelColors* New();
  vtkTypeMacro(vtkMarrowLabelColors, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The colour of a label; components in [0,1].
   */
  static void GetColor(vtkIdType label, double rgb[3]);

  /**
   * Fills `table` with the colours of the labels in `labels` (one component of any integer type),
   * as annotated values with IndexedLookup on: give it to a mapper that selects the label array.
   */
  static void FillLookupTable(vtkLookupTable* table, vtkDataArray* labels);

protected:
  vtkMarrowLabelColors() = default;
  ~vtkMarrowLabelColors() override = default;

private:
  vtkMarrowLabelColors(const vtkMarrowLabelColors&) = delete;
  void operator=(const vtkMarrowLabelColors&) = delete;
};

#endif
