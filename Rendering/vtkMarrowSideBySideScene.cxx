// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSideBySideScene.h"

#include "ArrayNames.h"
#include "Display.h"
#include "SceneLinks.h"
#include "SceneTile.h"
#include "Supersampling.h"
#include "vtkMarrowMeasureColors.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMarrowSideBySideScene);

namespace
{
/// In pixels of the picture.
constexpr double LinkWidth = 1.5;
/// Fewer fix no rotation.
constexpr std::size_t LeastLabels = 3;

std::size_t NumberOfCommonLabels(const marrow::LabelCentroids& a, const marrow::LabelCentroids& b)
{
  return std::count_if(
    a.begin(), a.end(), [&](const auto& labelled) { return b.count(labelled.first) > 0; });
}

/// How the tile has to be turned to stand like the first one.
Eigen::Matrix3d RotationOf(
  const marrow::SceneTile& tile, const marrow::SceneTile& first, const std::string& labelArray)
{
  const marrow::LabelCentroids reference = marrow::LabelCentroidsOf(first, labelArray);
  const marrow::LabelCentroids centroids = marrow::LabelCentroidsOf(tile, labelArray);
  return NumberOfCommonLabels(reference, centroids) >= LeastLabels
    ? marrow::RotationTo(reference, centroids)
    : marrow::RotationTo(marrow::MatchCentroidsOf(first), marrow::MatchCentroidsOf(tile));
}
}

struct vtkMarrowSideBySideScene::Content
{
  std::vector<marrow::SceneTile> Tiles;
  std::vector<vtkRenderer*> Renderers; ///< of the window filled last, which owns them
  std::unique_ptr<marrow::SceneLinks> Links;
};

vtkMarrowSideBySideScene::vtkMarrowSideBySideScene()
  : Internals(new Content)
{
  this->SetLabelArrayName(marrow::names::SegmentId);
}

vtkMarrowSideBySideScene::~vtkMarrowSideBySideScene()
{
  this->SetLabelArrayName(nullptr);
}

bool vtkMarrowSideBySideScene::HasDisplay()
{
  return marrow::CanOpenDisplay();
}

int vtkMarrowSideBySideScene::AddMesh(vtkPolyData* mesh, vtkPolyData* skeleton, const char* caption)
{
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("A tile needs a mesh: the one given is null or has no points.");
    return -1;
  }
  marrow::SceneTile tile;
  tile.Mesh = mesh;
  tile.Skeleton = skeleton;
  tile.Caption = caption ? caption : "";
  this->Internals->Tiles.push_back(tile);
  this->Modified();
  return static_cast<int>(this->Internals->Tiles.size()) - 1;
}

bool vtkMarrowSideBySideScene::HasTile(int tile)
{
  const int size = static_cast<int>(this->Internals->Tiles.size());
  if (tile < 0 || tile >= size)
  {
    vtkErrorMacro("There is no tile " << tile << ": the scene has " << size
                                      << ", and AddMesh returns the number of each.");
    return false;
  }
  this->Modified();
  return true;
}

void vtkMarrowSideBySideScene::SetSurfaceArray(int tile, const char* arrayName)
{
  if (!this->HasTile(tile))
  {
    return;
  }
  marrow::SceneTile& changed = this->Internals->Tiles[tile];
  changed.SurfaceArray = arrayName ? arrayName : "";
  if (!changed.SurfaceArray.empty() && !marrow::SurfaceArrayOf(changed, ""))
  {
    vtkErrorMacro("The mesh of tile " << tile << " has neither a point nor a cell array "
                                      << changed.SurfaceArray << " to be coloured by.");
    changed.SurfaceArray.clear();
  }
}

void vtkMarrowSideBySideScene::SetSurfaceRange(int tile, double low, double high)
{
  if (this->HasTile(tile))
  {
    this->Internals->Tiles[tile].SurfaceRange = { low, high };
  }
}

void vtkMarrowSideBySideScene::SetSurfaceLabels(int tile, const char* arrayName)
{
  if (!this->HasTile(tile))
  {
    return;
  }
  marrow::SceneTile& changed = this->Internals->Tiles[tile];
  changed.SurfaceLabels = arrayName ? arrayName : "";
  if (!changed.SurfaceLabels.empty() && !marrow::SurfaceArrayOf(changed, ""))
  {
    vtkErrorMacro("The mesh of tile " << tile << " has no cell array " << changed.SurfaceLabels
                                      << " of labels.");
    changed.SurfaceLabels.clear();
  }
}

void vtkMarrowSideBySideScene::SetTileOpacity(int tile, double opacity)
{
  if (this->HasTile(tile))
  {
    this->Internals->Tiles[tile].Opacity = vtkMath::ClampValue(opacity, 0.0, 1.0);
  }
}

void vtkMarrowSideBySideScene::AddCurves(
  int tile, vtkPolyData* curves, double red, double green, double blue, double radius)
{
  if (this->HasTile(tile) && curves)
  {
    this->Internals->Tiles[tile].Curves.push_back({ curves, { red, green, blue }, radius });
  }
}

void vtkMarrowSideBySideScene::AddActor(int tile, vtkActor* actor)
{
  if (this->HasTile(tile) && actor)
  {
    this->Internals->Tiles[tile].Actors.emplace_back(actor);
  }
}

void vtkMarrowSideBySideScene::SetCloseUp(int tile, vtkPolyData* part)
{
  if (this->HasTile(tile))
  {
    this->Internals->Tiles[tile].CloseUp = part;
  }
}

vtkRenderer* vtkMarrowSideBySideScene::GetRenderer(int tile)
{
  return tile >= 0 && tile < static_cast<int>(this->Internals->Renderers.size())
    ? this->Internals->Renderers[tile]
    : nullptr;
}

void vtkMarrowSideBySideScene::GetMeasureRange(int tile, double range[2]) const
{
  const std::vector<marrow::SceneTile>& tiles = this->Internals->Tiles;
  if (tiles[tile].SurfaceRange)
  {
    range[0] = tiles[tile].SurfaceRange->first;
    range[1] = tiles[tile].SurfaceRange->second;
    return;
  }
  vtkMarrowMeasureColors::GetRange(marrow::SurfaceArrayOf(tiles[tile], ""), range);
  for (const marrow::SceneTile& other : tiles)
  {
    if (this->ShareRange && other.SurfaceArray == tiles[tile].SurfaceArray)
    {
      double others[2];
      vtkMarrowMeasureColors::GetRange(marrow::SurfaceArrayOf(other, ""), others);
      range[0] = std::min(range[0], others[0]);
      range[1] = std::max(range[1], others[1]);
    }
  }
}

bool vtkMarrowSideBySideScene::Fill(vtkRenderWindow* window, int pixelScale)
{
  std::vector<marrow::SceneTile>& tiles = this->Internals->Tiles;
  if (tiles.empty())
  {
    vtkErrorMacro("The scene has no mesh: call AddMesh first.");
    return false;
  }

  marrow::SceneView view;
  const Eigen::Vector3d up = Eigen::Vector3d(this->ViewUp).normalized();
  Eigen::Vector3d toEye(this->ViewDirection);
  if (toEye.isZero())
  {
    toEye = marrow::BroadSide(marrow::PointsOf(tiles[0].Mesh), up);
  }
  Eigen::Vector3d right = up.cross(toEye);
  if (right.isZero())
  {
    vtkErrorMacro("ViewUp and ViewDirection are parallel: choose another ViewDirection.");
    return false;
  }
  const Eigen::AngleAxisd azimuth(vtkMath::RadiansFromDegrees(this->Azimuth), up);
  right = azimuth * right.normalized();
  const Eigen::AngleAxisd elevation(-vtkMath::RadiansFromDegrees(this->Elevation), right);
  view.Right = right;
  view.ToEye = elevation * right.cross(up);
  view.Up = view.ToEye.cross(view.Right);

  const int count = static_cast<int>(tiles.size());
  const int columns = this->Columns == 0 ? count : std::min(this->Columns, count);
  const int rows = (count + columns - 1) / columns;
  window->SetSize(pixelScale * columns * this->TileWidth, pixelScale * rows * this->TileHeight);

  const marrow::SceneStyle style = { this->LabelArrayName ? this->LabelArrayName : "",
    this->SurfaceOpacity, this->ColorSkeletonBy, this->TileWidth, this->TileHeight, pixelScale };
  // White also where a row has fewer tiles.
  vtkNew<vtkRenderer> background;
  background->SetBackground(1.0, 1.0, 1.0);
  background->InteractiveOff();
  window->AddRenderer(background);
  std::vector<vtkRenderer*>& renderers = this->Internals->Renderers;
  renderers.clear();
  for (int i = 0; i < count; ++i)
  {
    marrow::SceneTile& tile = tiles[i];
    tile.Rotation = this->Align && i > 0 ? RotationOf(tile, tiles[0], style.LabelArray)
                                         : Eigen::Matrix3d::Identity();
    double range[2];
    this->GetMeasureRange(i, range);
    const int column = i % columns;
    const int row = i / columns;
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(static_cast<double>(column) / columns,
      1.0 - static_cast<double>(row + 1) / rows, static_cast<double>(column + 1) / columns,
      1.0 - static_cast<double>(row) / rows);
    marrow::FillRenderer(renderer, tile, view, style, range);
    if (renderer->GetUseDepthPeeling())
    {
      // VTK peels nothing in a window that multisamples or has no alpha.
      window->SetMultiSamples(0);
      window->SetAlphaBitPlanes(1);
    }
    window->AddRenderer(renderer);
    renderers.push_back(renderer);
  }
  if (this->ShowLinks)
  {
    this->Internals->Links = std::make_unique<marrow::SceneLinks>(tiles, renderers);
    this->Internals->Links->AddTo(window, pixelScale * LinkWidth);
  }
  return true;
}

bool vtkMarrowSideBySideScene::AddTo(vtkRenderWindow* window)
{
  return this->Fill(window, 1);
}

bool vtkMarrowSideBySideScene::Render(vtkImageData* image)
{
  vtkNew<vtkRenderWindow> window;
  if (!this->Fill(window, marrow::Supersampling))
  {
    return false;
  }
  marrow::DrawSupersampled(window, image);
  // The window takes the renderers with it.
  this->Internals->Links.reset();
  this->Internals->Renderers.clear();
  return true;
}

bool vtkMarrowSideBySideScene::WritePNG(const char* fileName)
{
  vtkNew<vtkImageData> image;
  if (!this->Render(image))
  {
    return false;
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetCompressionLevel(9);
  writer->SetInputData(image);
  writer->SetFileName(fileName);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    vtkErrorMacro("The picture cannot be written to " << (fileName ? fileName : "(no name)")
                                                      << ": check the folder and its rights.");
    return false;
  }
  return true;
}

void vtkMarrowSideBySideScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMeshes: " << this->Internals->Tiles.size() << "\n";
  os << indent << "ViewUp: " << this->ViewUp[0] << " " << this->ViewUp[1] << " " << this->ViewUp[2]
     << "\n";
  os << indent << "ViewDirection: " << this->ViewDirection[0] << " " << this->ViewDirection[1]
     << " " << this->ViewDirection[2] << "\n";
  os << indent << "Azimuth: " << this->Azimuth << "\n";
  os << indent << "Elevation: " << this->Elevation << "\n";
  os << indent << "Align: " << this->Align << "\n";
  os << indent << "SurfaceOpacity: " << this->SurfaceOpacity << "\n";
  os << indent << "ColorSkeletonBy: " << this->ColorSkeletonBy << "\n";
  os << indent << "ShowLinks: " << this->ShowLinks << "\n";
  os << indent << "ShareRange: " << this->ShareRange << "\n";
  os << indent << "LabelArrayName: " << (this->LabelArrayName ? this->LabelArrayName : "(none)")
     << "\n";
  os << indent << "Tile: " << this->TileWidth << " x " << this->TileHeight << "\n";
  os << indent << "Columns: " << this->Columns << "\n";
}
