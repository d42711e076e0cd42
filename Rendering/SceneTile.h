// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SceneTile_h
#define marrow_SceneTile_h

#include "RigidAlignment.h"

#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkDataArray;
class vtkPolyData;
class vtkRenderer;

namespace marrow
{
/// Lines drawn on a tile's mesh.
struct SceneCurves
{
  vtkSmartPointer<vtkPolyData> Lines;
  Eigen::Vector3d Color;
  double Radius = 0.0; ///< of the mesh's diagonal
};

/// One mesh of a vtkMarrowSideBySideScene and what is drawn with it.
struct SceneTile
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Skeleton;
  std::string Caption;
  std::string SurfaceArray;                              ///< empty: the labels
  std::string SurfaceLabels;                             ///< empty: those of the scene
  std::optional<std::pair<double, double>> SurfaceRange; ///< none: that of the array
  double Opacity = -1.0;                                 ///< negative: the scene's
  vtkSmartPointer<vtkPolyData> CloseUp;                  ///< what the camera fits; null: the mesh
  std::vector<SceneCurves> Curves;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  /// From the mesh's coordinates to those of the first mesh.
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();
};

/// What a picture is seen from, in the coordinates of the first mesh.
struct SceneView
{
  Eigen::Vector3d Right, Up, ToEye;
};

/// What the scene says for all of its tiles.
struct SceneStyle
{
  std::string LabelArray;
  double Opacity = 1.0;
  int ColorSkeletonBy = 0;
  int TileWidth = 0;
  int TileHeight = 0;
  /// Pixels of the window for one of the picture.
  int PixelScale = 1;
};

std::vector<Eigen::Vector3d> PointsOf(vtkPolyData* mesh);

/// The centroids of a tile's labelled parts, area-weighted, so that they do not depend on where the
/// mesh is fine; or, without labels, of the nodes of its skeleton with equal CorrespondenceId.
LabelCentroids LabelCentroidsOf(const SceneTile& tile, const std::string& labelArray);
LabelCentroids MatchCentroidsOf(const SceneTile& tile);

/// The point or cell array that colours a tile's surface, null for none.
vtkDataArray* SurfaceArrayOf(const SceneTile& tile, const std::string& labelArray);

/// Puts the tile's actors, scalar bar, caption, lights and camera into `renderer`; `range` are the
/// ends of the colours of its measure, if it shows one.
void FillRenderer(vtkRenderer* renderer, const SceneTile& tile, const SceneView& view,
  const SceneStyle& style, const double range[2]);
}

#endif
