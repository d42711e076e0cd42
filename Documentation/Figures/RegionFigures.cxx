// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryTransfer.h"
#include "CoveringRegion.h"
#include "CylinderMap.h"
#include "Figures.h"
#include "GhostBoundary.h"
#include "MeshBridge.h"
#include "SegmentationTransfer.h"
#include "SkeletonMap.h"

#include <Eigen/LU>

#include <vtkCellData.h>
#include <vtkIntArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace figures
{
namespace
{
/// A loop around a front leg of the source, and where it sits.
struct LegLoop
{
  marrow::SegmentLoop Loop;
  marrow::Seat Seat;
};

std::vector<int> LabelsOf(vtkPolyData* mesh)
{
  std::vector<int> labels;
  marrow::GetArray(
    mesh->GetCellData(), "SegmentId", static_cast<int>(mesh->GetNumberOfCells()), labels);
  return labels;
}

/// The map of the matched skeletons with their chains aligned, as the transfer has it.
marrow::SkeletonMap AlignedMap(const Matched& pair)
{
  const marrow::TransferParameters defaults;
  return { pair.SourceMesh, pair.TargetMesh, pair.Match,
    marrow::AlignWithLandmarks(
      pair.SourceMesh, pair.TargetMesh, pair.Match, defaults.Theta, defaults.Kernel) };
}

/// The boundary of the source's segment `label`.
LegLoop FindLoop(const Matched& pair, int label)
{
  const marrow::SegmentPieces pieces =
    marrow::FindPieces(pair.SourceMesh.Mesh, LabelsOf(pair.Source.Mesh));
  for (const marrow::SegmentLoop& loop : marrow::FindLoops(pair.SourceMesh.Mesh, pieces))
  {
    const auto seat = marrow::FindSeat(pair.SourceMesh, pair.Match, loop);
    if (seat &&
      (pieces.LabelOfPiece[loop.LeftPiece] == label ||
        pieces.LabelOfPiece[loop.RightPiece] == label))
    {
      return { loop, *seat };
    }
  }
  throw std::runtime_error("There is no such boundary that encloses a branch.");
}

/// A boundary brought to the target with these settings of the snake.
struct Carried
{
  LegLoop Leg;
  marrow::BoundaryTransfer::Cut Cut;
};

Carried Carry(const Matched& pair, int label, double lambda, double searchRegion)
{
  const marrow::SkeletonMap map = AlignedMap(pair);
  marrow::BoundaryTransfer transfer(
    pair.SourceMesh, pair.TargetMesh, pair.Match, map, { lambda, searchRegion });
  const LegLoop leg = FindLoop(pair, label);
  auto cut = transfer.Transfer(leg.Loop, leg.Seat, map.TargetRatio(leg.Seat.Chain, leg.Seat.Ratio));
  if (!cut)
  {
    throw std::runtime_error("The boundary has no annulus on the target.");
  }
  return { leg, *cut };
}

/// The annulus of a mesh around a closed curve.
std::optional<marrow::CylinderMap> Unroll(const marrow::TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& curve, const Eigen::Vector3d& axis)
{
  std::vector<int> seeds;
  double edges = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    int nearest = 0;
    for (int v = 1; v < mesh.NumberOfVertices(); ++v)
    {
      if ((mesh.Points[v] - curve[i]).norm() < (mesh.Points[nearest] - curve[i]).norm())
      {
        nearest = v;
      }
    }
    if (seeds.empty() || seeds.back() != nearest)
    {
      seeds.push_back(nearest);
    }
    edges += (curve[i] - curve[(i + 1) % curve.size()]).norm() / curve.size();
  }
  marrow::FittingPlane plane = marrow::FitPlane(mesh, seeds);
  plane.Normal = plane.Normal.dot(axis) < 0.0 ? Eigen::Vector3d(-plane.Normal) : plane.Normal;
  double widest = 0.0;
  for (const int seed : seeds)
  {
    widest = std::max(widest, std::abs(plane.Offset(mesh.Points[seed])));
  }
  marrow::PathFinder paths(mesh);
  auto region = marrow::BuildCoveringRegion(mesh, paths, plane, seeds, widest + 2.5 * edges, seeds);
  return region
    ? marrow::CylinderMap::Build(paths, mesh, std::move(*region), plane.Center, plane.Normal)
    : std::nullopt;
}

/// The (u, v) of points of the surface, by the nearest triangle of the annulus.
std::vector<Eigen::Vector2d> UvOf(const marrow::CylinderMap& map, const marrow::TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector2d> result;
  for (const Eigen::Vector3d& point : points)
  {
    double least = std::numeric_limits<double>::infinity();
    Eigen::Vector2d uv;
    for (std::size_t t = 0; t < map.GetRegion().Triangles.size(); ++t)
    {
      const auto& corners = mesh.Triangles[map.GetRegion().Triangles[t]];
      Eigen::Matrix<double, 3, 2> sides;
      sides.col(0) = mesh.Points[corners[1]] - mesh.Points[corners[0]];
      sides.col(1) = mesh.Points[corners[2]] - mesh.Points[corners[0]];
      const Eigen::Vector2d weights = (sides.transpose() * sides).inverse() *
        (sides.transpose() * (point - mesh.Points[corners[0]]));
      // Far outside of the triangle the weights are far from [0, 1].
      const double outside = std::max({ 0.0, -weights.x(), -weights.y(), weights.sum() - 1.0 });
      const double distance =
        (mesh.Points[corners[0]] + sides * weights - point).norm() + outside * sides.norm();
      if (distance < least)
      {
        least = distance;
        uv = map.Corners(t)[0] + weights.x() * (map.Corners(t)[1] - map.Corners(t)[0]) +
          weights.y() * (map.Corners(t)[2] - map.Corners(t)[0]);
      }
    }
    result.emplace_back(uv.x() - std::floor(uv.x()), uv.y());
  }
  return result;
}

/// The triangles of an annulus in the (u, v) rectangle, and the curve in them.
Picture DrawRectangle(
  const marrow::CylinderMap& map, const std::vector<Eigen::Vector2d>& curve, const Color& color)
{
  Canvas canvas(420, 190);
  Axes axes(canvas, { 50, 45 }, { 410, 180 }, { 0, 0 }, { 1, 1 });
  for (std::size_t t = 0; t < map.GetRegion().Triangles.size(); ++t)
  {
    const auto& corners = map.Corners(t);
    // Corners are continuous in a triangle, wherever they lie on the real line.
    const double turns = std::floor((corners[0].x() + corners[1].x() + corners[2].x()) / 3.0);
    std::vector<Point> points;
    for (int k = 0; k < 4; ++k)
    {
      const Eigen::Vector2d& corner = corners[k % 3];
      points.push_back(axes.At(std::clamp(corner.x() - turns, 0.0, 1.0), corner.y()));
    }
    canvas.Lines(points, Grey, 0.6);
  }
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    const Eigen::Vector2d& a = curve[i];
    const Eigen::Vector2d& b = curve[(i + 1) % curve.size()];
    if (std::abs(a.x() - b.x()) < 0.5)
    {
      canvas.Lines({ axes.At(a.x(), a.y()), axes.At(b.x(), b.y()) }, color, 3);
    }
  }
  axes.Frame("u", "v");
  return canvas.Draw();
}

/// A mesh of which the annulus is coloured.
Data WithRegion(vtkPolyData* mesh, const std::vector<int>& triangles)
{
  const Data shown = Plain(mesh);
  vtkNew<vtkIntArray> labels;
  labels->SetName("SegmentId");
  labels->SetNumberOfValues(mesh->GetNumberOfCells());
  labels->Fill(-1);
  for (const int triangle : triangles)
  {
    labels->SetValue(triangle, 2);
  }
  shown->GetCellData()->AddArray(labels);
  return shown;
}

/// What is around a few points, for a close-up.
Data Around(vtkPolyData* mesh, const std::vector<Eigen::Vector3d>& points, double reach)
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points)
  {
    center += point / points.size();
  }
  return Faces(mesh,
    [&](vtkIdType face)
    {
      const Eigen::Vector3d corner(mesh->GetPoint(mesh->GetCell(face)->GetPointId(0)));
      return (corner - center).norm() < reach * mesh->GetLength();
    });
}

constexpr int Head = 2;

Picture DrawCoveringRegion(const std::string&)
{
  const Matched& pair = Quadrupeds();
  const marrow::TransferParameters defaults;
  const Carried carried = Carry(pair, Head, defaults.Lambda, defaults.SearchRegion);
  const marrow::TriangleMesh& sourceMesh = pair.SourceMesh.Mesh;
  const std::vector<Eigen::Vector3d> sourceCurve =
    PlacesOf(sourceMesh, carried.Leg.Loop.Vertices(sourceMesh));
  const std::vector<Eigen::Vector3d>& targetCurve = carried.Cut.Curve.Points;
  const Eigen::Vector3d forwards(1.0, 0.0, 0.0);
  auto source = Unroll(sourceMesh, sourceCurve, forwards);
  auto target = Unroll(pair.TargetMesh.Mesh, targetCurve, forwards);
  if (!source || !target)
  {
    throw std::runtime_error("There is no annulus around the boundary.");
  }
  const std::vector<Eigen::Vector2d> sourceUv = UvOf(*source, sourceMesh, sourceCurve);
  std::vector<Eigen::Vector2d> targetUv = UvOf(*target, pair.TargetMesh.Mesh, targetCurve);
  // The points correspond: turned by the mean difference, equal u is the same place on both.
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < sourceUv.size(); ++i)
  {
    const double angle = 2.0 * EIGEN_PI * (sourceUv[i].x() - targetUv[i].x());
    mean += Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  target->Rotate(std::atan2(mean.y(), mean.x()) / (2.0 * EIGEN_PI));
  targetUv = UvOf(*target, pair.TargetMesh.Mesh, targetCurve);
  const auto scene = Scene(420, 300);
  scene->AlignOff();
  const auto add = [&](vtkPolyData* mesh, const marrow::CylinderMap& map,
                     const std::vector<Eigen::Vector3d>& curve, const char* caption)
  {
    const Data part = Around(WithRegion(mesh, map.GetRegion().Triangles), curve, 0.16);
    scene->AddCurves(scene->AddMesh(part, nullptr, caption), ClosedLine(curve), Vermilion[0],
      Vermilion[1], Vermilion[2], 0.008);
  };
  add(pair.Source.Mesh, *source, sourceCurve, "source");
  add(pair.Target.Mesh, *target, targetCurve, "target");
  return Below({ Drawn(scene),
    Beside({ DrawRectangle(*source, sourceUv, Vermilion),
      DrawRectangle(*target, targetUv, Vermilion) }) });
}
}

Drawings RegionFigures()
{
  return { { "covering-region", DrawCoveringRegion } };
}
}
