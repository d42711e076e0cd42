// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSideBySideScene.h"

#include "ArrayNames.h"
#include "RigidAlignment.h"
#include "vtkLabelColors.h"
#include "vtkSkeletonGlyphs.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkImageShrink3D.h"
#include "vtkLightKit.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSideBySideScene);

namespace
{
/// The window is drawn larger by this factor and averaged: smooth edges that do not depend on what
/// the graphics driver offers.
constexpr int Supersampling = 2;
constexpr double Margin = 1.05;
/// Part of a tile's height that its caption takes.
constexpr double CaptionHeight = 0.09;
/// Brighter than VTK's 0.75, so that the label colours stay recognizable.
constexpr double KeyLightIntensity = 0.95;
constexpr double UnlabelledColor[3] = { 0.62, 0.73, 0.87 };

/// What a picture is seen from, in the coordinates of the first mesh.
struct View
{
  Eigen::Vector3d Right, Up, ToEye;
};

std::vector<Eigen::Vector3d> PointsOf(vtkPolyData* mesh)
{
  std::vector<Eigen::Vector3d> points(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, points[i].data());
  }
  return points;
}

/// Area-weighted, so that they do not depend on where the mesh is fine.
marrow::LabelCentroids CentroidsOf(vtkPolyData* mesh, const char* labelArray)
{
  marrow::LabelCentroids sums;
  std::map<int, double> areas;
  vtkDataArray* labels = mesh->GetCellData()->GetArray(labelArray);
  if (!labels)
  {
    return sums;
  }
  mesh->BuildCells();
  const std::vector<Eigen::Vector3d> points = PointsOf(mesh);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetCellPoints(cell, size, ids);
    const int label = static_cast<int>(labels->GetTuple1(cell));
    for (vtkIdType k = 2; label >= 0 && k < size; ++k)
    {
      const Eigen::Vector3d &a = points[ids[0]], &b = points[ids[k - 1]], &c = points[ids[k]];
      const double area = 0.5 * (b - a).cross(c - a).norm();
      auto [sum, isNew] = sums.try_emplace(label, Eigen::Vector3d::Zero());
      sum->second += area / 3.0 * (a + b + c);
      areas[label] += area;
    }
  }
  for (auto& [label, sum] : sums)
  {
    sum /= std::max(areas[label], 1e-300);
  }
  return sums;
}

vtkSmartPointer<vtkActor> SurfaceActor(vtkPolyData* mesh, const char* labelArray, double opacity)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkDataArray* labels = mesh->GetCellData()->GetArray(labelArray);
  if (labels)
  {
    vtkNew<vtkLookupTable> colors;
    vtkLabelColors::FillLookupTable(colors, labels);
    mapper->SetLookupTable(colors);
    mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectColorArray(labelArray);
    mapper->SetColorModeToMapScalars();
  }
  else
  {
    mapper->ScalarVisibilityOff();
    actor->GetProperty()->SetColor(UnlabelledColor[0], UnlabelledColor[1], UnlabelledColor[2]);
  }
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

vtkSmartPointer<vtkActor> SkeletonActor(vtkPolyData* skeleton, int colorBy)
{
  vtkNew<vtkSkeletonGlyphs> glyphs;
  glyphs->SetInputData(skeleton);
  glyphs->SetColorBy(colorBy);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(glyphs->GetOutputPort());
  mapper->SetScalarModeToUseCellData();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// Points the camera so that the turned mesh just fits the tile above its caption.
void FitCamera(vtkRenderer* renderer, const View& view, const std::vector<Eigen::Vector3d>& points,
  const Eigen::Matrix3d& rotation, double aspect, double captionHeight)
{
  Eigen::Matrix3d axes;
  axes << view.Right.transpose(), view.Up.transpose(), view.ToEye.transpose();
  const Eigen::Matrix3d toView = axes * rotation;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
  {
    box.extend(toView * point);
  }
  const double depth = std::max(box.diagonal().norm(), 1e-30);
  const double scale = Margin * 0.5 *
    std::max({ box.sizes().y() / (1.0 - captionHeight), box.sizes().x() / aspect, 1e-3 * depth });
  const Eigen::Vector3d focus =
    axes.transpose() * (box.center() - Eigen::Vector3d(0.0, captionHeight * scale, 0.0));
  const Eigen::Vector3d eye = focus + 2.0 * depth * view.ToEye;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(view.Up.data());
  camera->SetParallelScale(scale);
  camera->SetClippingRange(depth, 3.0 * depth);
}

void AddCaption(vtkRenderer* renderer, const std::string& text, int tileHeight)
{
  vtkNew<vtkTextActor> caption;
  caption->SetInput(text.c_str());
  caption->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  caption->GetTextProperty()->SetFontSize(Supersampling * std::max(10, tileHeight / 20));
  caption->GetTextProperty()->SetJustificationToCentered();
  caption->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  caption->SetPosition(0.5, 0.02);
  renderer->AddViewProp(caption);
}
}

struct vtkSideBySideScene::Tiles
{
  struct Tile
  {
    vtkSmartPointer<vtkPolyData> Mesh;
    vtkSmartPointer<vtkPolyData> Skeleton;
    std::string Caption;
  };
  std::vector<Tile> List;
};

vtkSideBySideScene::vtkSideBySideScene()
  : Internals(new Tiles)
{
  this->SetLabelArrayName(marrow::names::SegmentId);
}

vtkSideBySideScene::~vtkSideBySideScene()
{
  this->SetLabelArrayName(nullptr);
}

void vtkSideBySideScene::AddMesh(vtkPolyData* mesh, vtkPolyData* skeleton, const char* caption)
{
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("A tile needs a mesh: the one given is null or has no points.");
    return;
  }
  this->Internals->List.push_back({ mesh, skeleton, caption ? caption : "" });
  this->Modified();
}

bool vtkSideBySideScene::Render(vtkImageData* image)
{
  const std::vector<Tiles::Tile>& tiles = this->Internals->List;
  if (tiles.empty())
  {
    vtkErrorMacro("The scene has no mesh: call AddMesh first.");
    return false;
  }

  View view;
  const Eigen::Vector3d up = Eigen::Vector3d(this->ViewUp).normalized();
  Eigen::Vector3d toEye(this->ViewDirection);
  if (toEye.isZero())
  {
    toEye = marrow::BroadSide(PointsOf(tiles[0].Mesh), up);
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
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(
    Supersampling * columns * this->TileWidth, Supersampling * rows * this->TileHeight);

  const marrow::LabelCentroids reference = CentroidsOf(tiles[0].Mesh, this->LabelArrayName);
  for (int i = 0; i < count; ++i)
  {
    const Tiles::Tile& tile = tiles[i];
    const Eigen::Matrix3d rotation = this->Align && i > 0
      ? marrow::RotationTo(reference, CentroidsOf(tile.Mesh, this->LabelArrayName))
      : Eigen::Matrix3d::Identity();
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        matrix->SetElement(row, column, rotation(row, column));
      }
    }

    const int column = i % columns;
    const int row = i / columns;
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(static_cast<double>(column) / columns,
      1.0 - static_cast<double>(row + 1) / rows, static_cast<double>(column + 1) / columns,
      1.0 - static_cast<double>(row) / rows);
    renderer->SetBackground(1.0, 1.0, 1.0);
    if (this->SurfaceOpacity < 1.0)
    {
      renderer->UseDepthPeelingOn();
      renderer->SetMaximumNumberOfPeels(16);
      renderer->SetOcclusionRatio(0.0);
    }
    auto surface = SurfaceActor(tile.Mesh, this->LabelArrayName, this->SurfaceOpacity);
    surface->SetUserMatrix(matrix);
    renderer->AddActor(surface);
    if (tile.Skeleton)
    {
      auto skeleton = SkeletonActor(tile.Skeleton, this->ColorSkeletonBy);
      skeleton->SetUserMatrix(matrix);
      renderer->AddActor(skeleton);
    }
    if (!tile.Caption.empty())
    {
      AddCaption(renderer, tile.Caption, this->TileHeight);
    }
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightIntensity(KeyLightIntensity);
    lights->AddLightsToRenderer(renderer);
    FitCamera(renderer, view, PointsOf(tile.Mesh), rotation,
      static_cast<double>(this->TileWidth) / this->TileHeight,
      tile.Caption.empty() ? 0.0 : CaptionHeight);
    window->AddRenderer(renderer);
  }

  window->Render();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(capture->GetOutputPort());
  shrink->SetShrinkFactors(Supersampling, Supersampling, 1);
  shrink->MeanOn();
  shrink->Update();
  image->ShallowCopy(shrink->GetOutput());
  return true;
}

bool vtkSideBySideScene::WritePNG(const char* fileName)
{
  vtkNew<vtkImageData> image;
  if (!this->Render(image))
  {
    return false;
  }
  vtkNew<vtkPNGWriter> writer;
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

void vtkSideBySideScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMeshes: " << this->Internals->List.size() << "\n";
  os << indent << "ViewUp: " << this->ViewUp[0] << " " << this->ViewUp[1] << " " << this->ViewUp[2]
     << "\n";
  os << indent << "ViewDirection: " << this->ViewDirection[0] << " " << this->ViewDirection[1]
     << " " << this->ViewDirection[2] << "\n";
  os << indent << "Azimuth: " << this->Azimuth << "\n";
  os << indent << "Elevation: " << this->Elevation << "\n";
  os << indent << "Align: " << this->Align << "\n";
  os << indent << "SurfaceOpacity: " << this->SurfaceOpacity << "\n";
  os << indent << "ColorSkeletonBy: " << this->ColorSkeletonBy << "\n";
  os << indent << "LabelArrayName: " << (this->LabelArrayName ? this->LabelArrayName : "(none)")
     << "\n";
  os << indent << "Tile: " << this->TileWidth << " x " << this->TileHeight << "\n";
  os << indent << "Columns: " << this->Columns << "\n";
}
