// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Figures_h
#define marrow_Figures_h

#include "AnalyzedMesh.h"
#include "Canvas.h"
#include "MatchedSkeletons.h"

#include <vtkActor.h>
#include <vtkCreatureSource.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkPolyData.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

/// The documentation's pictures. Each is a function that draws it; a list of them by the names of the
/// files, one for each stage.
class vtkSegmentationTransfer;
class vtkSkeletonCorrespondence;

namespace figures
{
using Data = vtkSmartPointer<vtkPolyData>;

/// Draws a picture; the argument is the folder of libcgal-demo's meshes.
using Drawing = std::function<Picture(const std::string& meshes)>;
using Drawings = std::map<std::string, Drawing>;

Drawings MeasureFigures();
Drawings SkeletonFigures();
Drawings CorrespondenceFigures();
Drawings LoopFigures();
Drawings GhostFigures();
Drawings RegionFigures();
Drawings SnakeFigures();
Drawings TransferFigures();
Drawings LimitationFigures();
Drawings ReferenceFigures();

// Meshes

Data Creature(
  int shape, int seed, double pose = 0.0, double proportion = 0.0, int resolution = 10000);
Data ReadMesh(const std::string& folder, const std::string& name);
/// A copy of a mesh without its segments.
Data Plain(vtkPolyData* mesh);
/// An output of a filter that was run, apart from the filter.
Data Output(vtkAlgorithm* filter, int port = 0);

/// A mesh and its skeleton after vtkMSPSkeleton with its defaults.
struct Prepared
{
  Data Mesh;
  Data Skeleton;
};
Prepared Prepare(vtkPolyData* mesh);

/// A mesh and its skeleton as the algorithms of the transfer see them.
marrow::AnalyzedMesh Analyze(vtkPolyData* mesh);

/// Two such, matched, as vtkSegmentationTransfer sees them.
struct Matched
{
  Prepared Source;
  Prepared Target;
  marrow::AnalyzedMesh SourceMesh;
  marrow::AnalyzedMesh TargetMesh;
  marrow::MatchedSkeletons Match;
};
Matched MatchCreatures(vtkPolyData* source, vtkPolyData* target);

/// Source and target of most pictures: a quadruped, and one that is bent and of other proportions.
const Matched& Quadrupeds();

/// What vtkSegmentationTransfer makes of two such.
struct Transferred
{
  Data Target;
  Data SourceBoundaries;
  Data TargetBoundaries;
};
using TransferSettings = std::function<void(vtkSegmentationTransfer*)>;
Transferred Transfer(
  const Prepared& source, const Prepared& target,
  const TransferSettings& set = [](vtkSegmentationTransfer*) {});

// Drawing

/// A scene whose tiles are of this size.
vtkSmartPointer<vtkMarrowSideBySideScene> Scene(int tileWidth, int tileHeight);
Picture Drawn(vtkMarrowSideBySideScene* scene);
Picture Beside(const std::vector<Picture>& pictures);
Picture Below(const std::vector<Picture>& pictures);

using CorrespondenceSettings = std::function<void(vtkSkeletonCorrespondence*)>;
/// Two skeletons, matched, with links between equal nodes.
Picture DrawMatch(
  const Prepared& source, const Prepared& target, int tileWidth, int tileHeight,
  const std::string& caption,
  const CorrespondenceSettings& set = [](vtkSkeletonCorrespondence*) {});

/// The places of vertices, in order.
std::vector<Eigen::Vector3d> PlacesOf(
  const marrow::TriangleMesh& mesh, const std::vector<int>& vertices);
Data ClosedLine(const std::vector<Eigen::Vector3d>& points);
Data Line(const std::vector<Eigen::Vector3d>& points);
Data Segments(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& ends);
vtkSmartPointer<vtkActor> Ball(const Eigen::Vector3d& center, double radius, const Color& color);
/// The faces of a mesh for which `isIn` holds, with all of its arrays.
Data Faces(vtkPolyData* mesh, const std::function<bool(vtkIdType)>& isIn);
}

#endif
