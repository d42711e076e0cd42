// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLabelColors
 * @brief   categorical colours that depend on nothing but the label
 *
 * Equal labels have equal colours on every mesh, whatever other labels are there, so that pictures
 * of a source and of its targets can be compared by eye. Labels 0 to 11 have twelve colours that
 * people with colour-deficient vision tell apart (the seven of Okabe and Ito 2008 without black,
 * and five of Tol's "muted" scheme, 2021); the next twelve are the same ones darkened, and then
 * they repeat. Negative labels (-1: unmatched, unlabelled) are light grey.
 */
#ifndef vtkLabelColors_h
#define vtkLabelColors_h

#include "MarrowRenderingModule.h"
#include "vtkObject.h"

class vtkDataArray;
class vtkLookupTable;

class MARROWRENDERING_EXPORT vtkLabelColors : public vtkObject
{
public:
  static vtkLabelColors* New();
  vtkTypeMacro(vtkLabelColors, vtkObject);
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
  vtkLabelColors() = default;
  ~vtkLabelColors() override = default;

private:
  vtkLabelColors(const vtkLabelColors&) = delete;
  void operator=(const vtkLabelColors&) = delete;
};

#endif
