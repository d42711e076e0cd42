// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowMeasureColors
 * @brief   colours of measures on a surface (MSP, AGD, gradient, ...), and their scalar bar
 *
 * Measures that do not change their sign have the colours of viridis (Smith and van der Walt 2015),
 * dark to bright, which everybody tells apart also in grey. Those that do, as dihedral angles, go
 * from blue over white (0) to vermilion. Vectors are coloured by their length.
 *
 * MSP and its gradient have a few values far above the others. So the colours end at the 95th
 * percentile of what is there if the largest value is more than 3 times as large, and at the
 * largest value otherwise.
 */
#ifndef vtkMarrowMeasureColors_h
#define vtkMarrowMeasureColors_h

#include "MarrowRenderingModule.h"
#include "vtkObject.h"

class vtkDataArray;
class vtkLookupTable;
class vtkScalarBarActor;

class MARROWRENDERING_EXPORT vtkMarrowMeasureColors : public vtkObject
{
public:
  static vtkMarrowMeasureColors* New();
  vtkTypeMacro(vtkMarrowMeasureColors, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What the colours of `measure` reach from and to, see above; (0, 1) without finite values.
   */
  static void GetRange(vtkDataArray* measure, double range[2]);

  /**
   * Fills `table` with 256 colours over `range`; the diverging ones if the range holds 0 inside.
   * Give it to a mapper that selects the measure's array.
   */
  static void FillLookupTable(vtkLookupTable* table, const double range[2]);

  /**
   * Makes `bar` a horizontal scalar bar of `table` with dark text of `fontSize` pixels.
   */
  static void SetUpScalarBar(
    vtkScalarBarActor* bar, vtkLookupTable* table, const char* title, int fontSize);

protected:
  vtkMarrowMeasureColors() = default;
  ~vtkMarrowMeasureColors() override = default;

private:
  vtkMarrowMeasureColors(const vtkMarrowMeasureColors&) = delete;
  void operator=(const vtkMarrowMeasureColors&) = delete;
};

#endif
