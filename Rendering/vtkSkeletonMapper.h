// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkeletonMapper
 * @brief   draws a skeleton: tubes along the branches, balls at the feature nodes
 *
 * The mapper of an actor that is a skeleton. What it draws is made by vtkSkeletonGlyphs, which says
 * what the input is and what the colours and sizes mean; set these at GetGlyphs().
 *
 * Its data set is the skeleton itself, so a vtkCellPicker with a tolerance that hits the actor tells
 * the branch: GetCellId() is the polyline.
 */
#ifndef vtkSkeletonMapper_h
#define vtkSkeletonMapper_h

#include "MarrowRenderingModule.h"
#include "vtkMapper.h"
#include "vtkSmartPointer.h"

class vtkPolyDataMapper;
class vtkSkeletonGlyphs;

class MARROWRENDERING_EXPORT vtkSkeletonMapper : public vtkMapper
{
public:
  static vtkSkeletonMapper* New();
  vtkTypeMacro(vtkSkeletonMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What shapes the skeleton: ColorBy, TubeRadius, BallRadius and so on.
   */
  vtkSkeletonGlyphs* GetGlyphs();

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  using vtkMapper::GetBounds;
  vtkMTimeType GetMTime() override;
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;

protected:
  vtkSkeletonMapper();
  ~vtkSkeletonMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkSkeletonMapper(const vtkSkeletonMapper&) = delete;
  void operator=(const vtkSkeletonMapper&) = delete;

  /// Brings the drawn surface up to date; false without an input.
  bool UpdateSurface();

  vtkSmartPointer<vtkSkeletonGlyphs> Glyphs;
  vtkSmartPointer<vtkPolyDataMapper> Surface;
};

#endif
