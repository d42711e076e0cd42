// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowSideBySideScene
 * @brief   labelled meshes in one picture, each in a tile of its own, seen from the same side
 *
 * The scene of the examples, tests and documentation. Every mesh fills its tile whatever its units.
 * Labels (integer cell array LabelArrayName) have the colours of vtkMarrowLabelColors, so equal labels
 * have equal colours in all tiles; a mesh without them is light blue. SetSurfaceArray shows a measure
 * instead, in the colours of vtkMarrowMeasureColors and with a scalar bar.
 *
 * The view is that of the first mesh: its ViewUp points up, and ViewDirection leads from the mesh
 * to the eye. With Align on, every other mesh that shares at least three labels with the first is
 * turned so that its parts stand where the first one's parts stand (least squares over the labels'
 * centroids); so meshes whose files have different up axes need no hand, and a wrong label is seen
 * at once. Where there are no such labels, matched skeletons (point array CorrespondenceId) with three
 * ids in common do as well. All other meshes are seen as they are.
 *
 * Write the picture (WritePNG, Render), or show the scene in a window of one's own (AddTo).
 *
 * A picture needs an X display (Debian's VTK draws with GLX); see Documentation/testing.md.
 */
#ifndef vtkMarrowSideBySideScene_h
#define vtkMarrowSideBySideScene_h

#include "MarrowRenderingModule.h"
#include "vtkObject.h"

#include <memory>

class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

class MARROWRENDERING_EXPORT vtkMarrowSideBySideScene : public vtkObject
{
public:
  static vtkMarrowSideBySideScene* New();
  vtkTypeMacro(vtkMarrowSideBySideScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether there is an X display to draw with, named by the environment variable DISPLAY. Ask before
   * the first picture: where there is none, VTK ends the program.
   */
  static bool HasDisplay();

  /**
   * Adds a tile, from left to right and then row by row, and returns its index, or -1 with an error
   * event where there is no mesh. `skeleton` and `caption` may be null. The skeleton is drawn by
   * vtkMarrowSkeletonMapper; it shows where the surface's opacity is less than 1, and can be picked through
   * that surface then.
   */
  int AddMesh(vtkPolyData* mesh, vtkPolyData* skeleton = nullptr, const char* caption = nullptr);

  /**
   * Colours a tile's surface by a point or cell array (a measure) and adds a scalar bar. An error
   * event tells of a tile or array that does not exist.
   */
  void SetSurfaceArray(int tile, const char* arrayName);

  /**
   * The values at the ends of a tile's colours and scalar bar, in place of those of its array.
   */
  void SetSurfaceRange(int tile, double low, double high);

  /**
   * Colours a tile's surface by another integer cell array of labels. The mesh stands as by LabelArrayName, so
   * that two labellings of it can be compared. An error event tells of a tile or array that does not exist.
   */
  void SetSurfaceLabels(int tile, const char* arrayName);

  /**
   * The opacity of one tile's surface in place of SurfaceOpacity, range [0, 1].
   */
  void SetTileOpacity(int tile, double opacity);

  /**
   * Draws polylines on a tile (boundaries, slices) as tubes of a colour; `radius` is a fraction of
   * the mesh's diagonal.
   */
  void AddCurves(
    int tile, vtkPolyData* curves, double red, double green, double blue, double radius = 0.004);

  /**
   * Draws whatever else on a tile. The actor stands in the coordinates of the mesh; the scene turns
   * it with the mesh.
   */
  void AddActor(int tile, vtkActor* actor);

  /**
   * Fills the tile with `part` in place of the whole mesh.
   */
  void SetCloseUp(int tile, vtkPolyData* part);

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
  /**
   * What the skeletons' colours tell: vtkMarrowSkeletonGlyphs::ColorByEnum, default NODE_TYPE. For LABEL
   * the nodes take the label that most of their part of the surface has, where the mesh has the
   * labels and the point array SkeletonNodeId.
   */
  vtkSetClampMacro(ColorSkeletonBy, int, 0, 3);
  vtkGetMacro(ColorSkeletonBy, int);
  ///@}

  ///@{
  /**
   * Lines from the feature nodes of the first skeleton to those of the others that have the same
   * CorrespondenceId. Default off.
   */
  vtkSetMacro(ShowLinks, bool);
  vtkGetMacro(ShowLinks, bool);
  vtkBooleanMacro(ShowLinks, bool);
  ///@}

  ///@{
  /**
   * One range of colours for all tiles that show the same array, so that equal colours are equal
   * values; else each tile has its own. Default off.
   */
  vtkSetMacro(ShareRange, bool);
  vtkGetMacro(ShareRange, bool);
  vtkBooleanMacro(ShareRange, bool);
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
   * Shows the scene in `window`: sets its size, and adds a renderer for each tile. Where a surface is
   * transparent, the window's multisampling goes and it gets alpha bit planes, or VTK would leave that
   * surface out. The scene has to live as long as the window. Returns false, with an error event,
   * when there is no mesh.
   */
  bool AddTo(vtkRenderWindow* window);

  /**
   * The renderer of a tile in the window of the last AddTo, null before.
   */
  vtkRenderer* GetRenderer(int tile);

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
  vtkMarrowSideBySideScene();
  ~vtkMarrowSideBySideScene() override;

private:
  vtkMarrowSideBySideScene(const vtkMarrowSideBySideScene&) = delete;
  void operator=(const vtkMarrowSideBySideScene&) = delete;

  struct Content;
  bool HasTile(int tile);
  bool Fill(vtkRenderWindow* window, int pixelScale);
  void GetMeasureRange(int tile, double range[2]) const;

  std::unique_ptr<Content> Internals;

  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  double ViewDirection[3] = { 0.0, 0.0, 0.0 };
  double Azimuth = 25.0;
  double Elevation = 12.0;
  bool Align = true;
  double SurfaceOpacity = 1.0;
  int ColorSkeletonBy = 0;
  bool ShowLinks = false;
  bool ShareRange = false;
  char* LabelArrayName = nullptr;
  int TileWidth = 400;
  int TileHeight = 400;
  int Columns = 0;
};

#endif
