// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowSkeletonMapper
 * @brief   draws a skeleton: tubes along the branches, balls at the feature nodes
 *
 * The mapper of an actor that is a skeleton. What it draws is made by vtkMarrowSkeletonGlyphs, which says
 * what the input is and what the colours and sizes mean; set these at GetGlyphs().
 *
 * Its data set is the skeleton itself, so a vtkCellPicker with a tolerance that hits the actor tells
 * the branch: GetCellId() is the polyline.
 */
#ifndef vtkMarrowSkeletonMapper_h
#define vtkMarrowSkeletonMapper_h

#include "MarrowRenderingModule.h"
#include "vtkMapper.h"
#include "vtkSmartPointer.h"

class vtkPolyDataMapper;
class vtkMarrowSkeletonGlyphs;

class MARROWRENDERING_EXPORT vtkMarrowSkeletonMapper : public vtkMapper
{
public:
  static vtkMarrowSkeletonMapper* New();
  vtkTypeMacro(vtkMarrowSkeletonMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What shapes the skeleton: ColorBy, TubeRadius, BallRadius and so on.
   */
  vtkMarrowSkeletonGlyphs* GetGlyphs();

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  using vtkMapper::GetBounds;
  vtkMTimeType GetMTime() override;
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;

protected:
  vtkMarrowSkeletonMapper();
  ~vtkMarrowSkeletonMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkMarrowSkeletonMapper(const vtkMarrowSkeletonMapper&) = delete;
  void operator=(const vtkMarrowSkeletonMapper&) = delete;

  /// Brings the drawn surface up to date; false without an input.
  bool UpdateSurface();

  vtkSmartPointer<vtkMarrowSkeletonGlyphs> Glyphs;
  vtkSmartPointer<vtkPolyDataMapper> Surface;
};

#endif
