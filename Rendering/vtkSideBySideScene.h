// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSideBySideScene
 * @brief   labelled meshes in one picture, each in a tile of its own, seen from the same side
 *
 * The scene of the examples, tests and documentation. Every mesh fills its tile whatever its units.
 * Labels (integer cell array LabelArrayName) have the colours of vtkLabelColors, so equal labels
 * have equal colours in all tiles; a mesh without them is light blue.
 *
 * The view is that of the first mesh: its ViewUp points up, and ViewDirection leads from the mesh
 * to the eye. With Align on, every other mesh that shares at least three labels with the first is
 * turned so that its parts stand where the first one's parts stand (least squares over the labels'
 * centroids); so meshes whose files have different up axes need no hand, and a wrong label is seen
 * at once. All other meshes are seen as they are.
 *
 * A picture needs an X display (Debian's VTK draws with GLX); see Documentation/testing.md.
 */
#ifndef vtkSideBySideScene_h
#define vtkSideBySideScene_h

#include "MarrowRenderingModule.h"
#include "vtkObject.h"

#include <memory>

class vtkImageData;
class vtkPolyData;

class MARROWRENDERING_EXPORT vtkSideBySideScene : public vtkObject
{
public:
  static vtkSideBySideScene* New();
  vtkTypeMacro(vtkSideBySideScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds a tile, from left to right and then row by row. `skeleton` and `caption` may be null. The
   * skeleton is drawn by vtkSkeletonGlyphs; it shows where SurfaceOpacity is less than 1.
   */
  void AddMesh(vtkPolyData* mesh, vtkPolyData* skeleton = nullptr, const char* caption = nullptr);

  ///@{
  /** Direction that is up in the first mesh. Default (0, 1, 0). */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Direction from the first mesh to the eye. Default (0, 0, 0): perpendicular to ViewUp, the
   * direction along which the mesh spreads least, so an animal is seen from its side.
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * Turn of the eye away from ViewDirection, to the side and upwards, in degrees: legs do not hide
   * one another. Defaults 25 and 12, range [-180, 180] and [-89, 89].
   */
  vtkSetClampMacro(Azimuth, double, -180.0, 180.0);
  vtkGetMacro(Azimuth, double);
  vtkSetClampMacro(Elevation, double, -89.0, 89.0);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /** Turn the other meshes to stand like the first one. Default on. */
  vtkSetMacro(Align, bool);
  vtkGetMacro(Align, bool);
  vtkBooleanMacro(Align, bool);
  ///@}

  ///@{
  /** Opacity of the surfaces, range [0, 1]. Default 1. */
  vtkSetClampMacro(SurfaceOpacity, double, 0.0, 1.0);
  vtkGetMacro(SurfaceOpacity, double);
  ///@}

  ///@{
  /** What the skeletons' colours tell: vtkSkeletonGlyphs::ColorByEnum. Default NODE_TYPE. */
  vtkSetClampMacro(ColorSkeletonBy, int, 0, 1);
  vtkGetMacro(ColorSkeletonBy, int);
  ///@}

  ///@{
  /** Name of the integer cell array that holds the labels. Default "SegmentId". */
  vtkSetStringMacro(LabelArrayName);
  vtkGetStringMacro(LabelArrayName);
  ///@}

  ///@{
  /** Size of a tile in pixels. Default 400 x 400, range [16, 4096] each. */
  vtkSetClampMacro(TileWidth, int, 16, 4096);
  vtkGetMacro(TileWidth, int);
  vtkSetClampMacro(TileHeight, int, 16, 4096);
  vtkGetMacro(TileHeight, int);
  ///@}

  ///@{
  /** Tiles in a row. Default 0: all in one row. */
  vtkSetClampMacro(Columns, int, 0, 64);
  vtkGetMacro(Columns, int);
  ///@}

  /**
   * Draws the scene offscreen into `image` (RGB, unsigned char). Returns false, with an error
   * event, when there is no mesh.
   */
  bool Render(vtkImageData* image);

  /**
   * Draws the scene and writes it as PNG. Returns false, with an error event, when there is no mesh
   * or the file cannot be written.
   */
  bool WritePNG(const char* fileName);

protected:
  vtkSideBySideScene();
  ~vtkSideBySideScene() override;

private:
  vtkSideBySideScene(const vtkSideBySideScene&) = delete;
  void operator=(const vtkSideBySideScene&) = delete;

  struct Tiles;
  std::unique_ptr<Tiles> Internals;

  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  double ViewDirection[3] = { 0.0, 0.0, 0.0 };
  double Azimuth = 25.0;
  double Elevation = 12.0;
  bool Align = true;
  double SurfaceOpacity = 1.0;
  int ColorSkeletonBy = 0;
  char* LabelArrayName = nullptr;
  int TileWidth = 400;
  int TileHeight = 400;
  int Columns = 0;
};

#endif
