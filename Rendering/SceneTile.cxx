// SPDX-License-Identifier: BSD-3-Clause
#include "SceneTile.h"

#include "ArrayNames.h"
#include "vtkMarrowLabelColors.h"
#include "vtkMarrowMeasureColors.h"
#include "vtkMarrowSkeletonGlyphs.h"
#include "vtkMarrowSkeletonMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkLightKit.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace marrow
{
namespace
{
constexpr double Margin = 1.05;
/// Parts of a tile's height that its caption and its scalar bar take.
constexpr double CaptionHeight = 0.09;
constexpr double ScalarBarHeight = 0.17;
/// Brighter than VTK's 0.75, so that the label colours stay recognizable.
constexpr double KeyLightIntensity = 0.95;
constexpr double UnlabelledColor[3] = { 0.62, 0.73, 0.87 };

bool ShowsMeasure(const SceneTile& tile)
{
  return !tile.SurfaceArray.empty();
}

vtkSmartPointer<vtkActor> SurfaceActor(
  const SceneTile& tile, const SceneStyle& style, vtkLookupTable* colors)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(tile.Mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  const double opacity = tile.Opacity < 0.0 ? style.Opacity : tile.Opacity;
  actor->GetProperty()->SetOpacity(opacity);
  actor->SetPickable(!tile.Skeleton || opacity == 1.0);
  vtkDataArray* array = SurfaceArrayOf(tile, style.LabelArray);
  if (!array)
  {
    mapper->ScalarVisibilityOff();
    actor->GetProperty()->SetColor(UnlabelledColor[0], UnlabelledColor[1], UnlabelledColor[2]);
    return actor;
  }
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetColorModeToMapScalars();
  if (array == tile.Mesh->GetPointData()->GetArray(array->GetName()))
  {
    mapper->SetScalarModeToUsePointFieldData();
    mapper->InterpolateScalarsBeforeMappingOn();
  }
  else
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  mapper->SelectColorArray(array->GetName());
  return actor;
}

/// Gives each node the label that most of its φ has, where the mesh knows both.
vtkSmartPointer<vtkPolyData> WithNodeLabels(const SceneTile& tile, const std::string& labelArray)
{
  vtkDataArray* nodes = tile.Mesh->GetPointData()->GetArray(names::SkeletonNodeId);
  vtkDataArray* labels = tile.Mesh->GetCellData()->GetArray(labelArray.c_str());
  const vtkIdType size = tile.Skeleton->GetNumberOfPoints();
  if (tile.Skeleton->GetPointData()->HasArray(labelArray.c_str()) || !nodes || !labels)
  {
    return tile.Skeleton;
  }
  std::vector<std::map<int, int>> votes(size);
  tile.Mesh->BuildCells();
  for (vtkIdType cell = 0; cell < tile.Mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    tile.Mesh->GetCellPoints(cell, corners, ids);
    for (vtkIdType k = 0; k < corners; ++k)
    {
      const auto node = static_cast<vtkIdType>(nodes->GetTuple1(ids[k]));
      if (node >= 0 && node < size)
      {
        ++votes[node][static_cast<int>(labels->GetTuple1(cell))];
      }
    }
  }
  vtkNew<vtkIntArray> nodeLabels;
  nodeLabels->SetName(labelArray.c_str());
  for (const std::map<int, int>& votesOfNode : votes)
  {
    const auto best = std::max_element(votesOfNode.begin(), votesOfNode.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    nodeLabels->InsertNextValue(best == votesOfNode.end() ? -1 : best->first);
  }
  auto skeleton = vtkSmartPointer<vtkPolyData>::New();
  skeleton->ShallowCopy(tile.Skeleton);
  skeleton->GetPointData()->AddArray(nodeLabels);
  return skeleton;
}

vtkSmartPointer<vtkActor> SkeletonActor(const SceneTile& tile, const SceneStyle& style)
{
  vtkNew<vtkMarrowSkeletonMapper> mapper;
  mapper->GetGlyphs()->SetColorBy(style.ColorSkeletonBy);
  mapper->GetGlyphs()->SetLabelArrayName(style.LabelArray.c_str());
  mapper->SetInputDataObject(style.ColorSkeletonBy == vtkMarrowSkeletonGlyphs::LABEL
      ? WithNodeLabels(tile, style.LabelArray)
      : tile.Skeleton);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> CurvesActor(const SceneTile& tile, const SceneCurves& curves)
{
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(curves.Lines);
  tube->SetRadius(curves.Radius * tile.Mesh->GetLength());
  tube->SetNumberOfSides(10);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(curves.Color.x(), curves.Color.y(), curves.Color.z());
  return actor;
}

/// Points the camera so that the turned points just fit the tile above what stands at its bottom.
void FitCamera(vtkRenderer* renderer, const SceneTile& tile, const SceneView& view, double aspect,
  double bottomHeight)
{
  Eigen::Matrix3d axes;
  axes << view.Right.transpose(), view.Up.transpose(), view.ToEye.transpose();
  const Eigen::Matrix3d toView = axes * tile.Rotation;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : PointsOf(tile.CloseUp ? tile.CloseUp : tile.Mesh))
  {
    box.extend(toView * point);
  }
  // The whole mesh stays between the clipping planes, also where only a part of it fills the tile.
  const double depth = std::max({ box.diagonal().norm(), tile.Mesh->GetLength(), 1e-30 });
  const double scale = Margin * 0.5 *
    std::max({ box.sizes().y() / (1.0 - bottomHeight), box.sizes().x() / aspect, 1e-3 * depth });
  const Eigen::Vector3d focus =
    axes.transpose() * (box.center() - Eigen::Vector3d(0.0, bottomHeight * scale, 0.0));
  const Eigen::Vector3d eye = focus + 2.0 * depth * view.ToEye;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(view.Up.data());
  camera->SetParallelScale(scale);
  camera->SetClippingRange(depth, 3.0 * depth);
}

void AddCaption(vtkRenderer* renderer, const std::string& text, int fontSize)
{
  vtkNew<vtkTextActor> caption;
  caption->SetInput(text.c_str());
  caption->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  caption->GetTextProperty()->SetFontSize(fontSize);
  caption->GetTextProperty()->SetJustificationToCentered();
  caption->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  caption->SetPosition(0.5, 0.02);
  renderer->AddViewProp(caption);
}

void AddScalarBar(
  vtkRenderer* renderer, vtkLookupTable* colors, vtkDataArray* measure, int fontSize, double bottom)
{
  vtkNew<vtkScalarBarActor> bar;
  const std::string name = measure->GetName();
  const std::string title = measure->GetNumberOfComponents() > 1 ? "|" + name + "|" : name;
  vtkMarrowMeasureColors::SetUpScalarBar(bar, colors, title.c_str(), fontSize);
  bar->SetPosition(0.15, bottom + 0.01);
  bar->SetPosition2(0.7, ScalarBarHeight - 0.02);
  renderer->AddViewProp(bar);
}
}

std::vector<Eigen::Vector3d> PointsOf(vtkPolyData* mesh)
{
  std::vector<Eigen::Vector3d> points(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, points[i].data());
  }
  return points;
}

LabelCentroids LabelCentroidsOf(const SceneTile& tile, const std::string& labelArray)
{
  LabelCentroids sums;
  std::map<int, double> areas;
  vtkDataArray* labels = tile.Mesh->GetCellData()->GetArray(labelArray.c_str());
  if (!labels)
  {
    return sums;
  }
  tile.Mesh->BuildCells();
  const std::vector<Eigen::Vector3d> points = PointsOf(tile.Mesh);
  for (vtkIdType cell = 0; cell < tile.Mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    tile.Mesh->GetCellPoints(cell, size, ids);
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

LabelCentroids MatchCentroidsOf(const SceneTile& tile)
{
  LabelCentroids sums;
  std::map<int, int> counts;
  vtkDataArray* ids =
    tile.Skeleton ? tile.Skeleton->GetPointData()->GetArray(names::CorrespondenceId) : nullptr;
  for (vtkIdType node = 0; ids && node < tile.Skeleton->GetNumberOfPoints(); ++node)
  {
    const int id = static_cast<int>(ids->GetTuple1(node));
    if (id >= 0)
    {
      auto [sum, isNew] = sums.try_emplace(id, Eigen::Vector3d::Zero());
      sum->second += Eigen::Vector3d(tile.Skeleton->GetPoint(node));
      ++counts[id];
    }
  }
  for (auto& [id, sum] : sums)
  {
    sum /= counts[id];
  }
  return sums;
}

vtkDataArray* SurfaceArrayOf(const SceneTile& tile, const std::string& labelArray)
{
  if (!ShowsMeasure(tile))
  {
    const std::string& labels = tile.SurfaceLabels.empty() ? labelArray : tile.SurfaceLabels;
    return tile.Mesh->GetCellData()->GetArray(labels.c_str());
  }
  vtkDataArray* ofPoints = tile.Mesh->GetPointData()->GetArray(tile.SurfaceArray.c_str());
  return ofPoints ? ofPoints : tile.Mesh->GetCellData()->GetArray(tile.SurfaceArray.c_str());
}

void FillRenderer(vtkRenderer* renderer, const SceneTile& tile, const SceneView& view,
  const SceneStyle& style, const double range[2])
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, tile.Rotation(row, column));
    }
  }
  renderer->SetBackground(1.0, 1.0, 1.0);
  if ((tile.Opacity < 0.0 ? style.Opacity : tile.Opacity) < 1.0)
  {
    renderer->UseDepthPeelingOn();
    renderer->SetMaximumNumberOfPeels(16);
    renderer->SetOcclusionRatio(0.0);
  }

  vtkNew<vtkLookupTable> colors;
  if (ShowsMeasure(tile))
  {
    vtkMarrowMeasureColors::FillLookupTable(colors, range);
  }
  else
  {
    vtkMarrowLabelColors::FillLookupTable(colors, SurfaceArrayOf(tile, style.LabelArray));
  }
  std::vector<vtkSmartPointer<vtkActor>> actors = tile.Actors;
  actors.push_back(SurfaceActor(tile, style, colors));
  if (tile.Skeleton)
  {
    actors.push_back(SkeletonActor(tile, style));
  }
  for (const SceneCurves& curves : tile.Curves)
  {
    actors.push_back(CurvesActor(tile, curves));
  }
  for (const vtkSmartPointer<vtkActor>& actor : actors)
  {
    actor->SetUserMatrix(matrix);
    renderer->AddActor(actor);
  }

  const int fontSize = style.PixelScale * std::max(10, style.TileHeight / 20);
  double bottom = 0.0;
  if (!tile.Caption.empty())
  {
    AddCaption(renderer, tile.Caption, fontSize);
    bottom += CaptionHeight;
  }
  if (ShowsMeasure(tile))
  {
    AddScalarBar(
      renderer, colors, SurfaceArrayOf(tile, style.LabelArray), 4 * fontSize / 5, bottom);
    bottom += ScalarBarHeight;
  }
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(KeyLightIntensity);
  lights->AddLightsToRenderer(renderer);
  FitCamera(renderer, tile, view, static_cast<double>(style.TileWidth) / style.TileHeight, bottom);
}
}
