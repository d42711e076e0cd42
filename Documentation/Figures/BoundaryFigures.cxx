// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryTransfer.h"
#include "CoveringRegion.h"
#include "CylinderMap.h"
#include "Figures.h"
#include "GhostBoundary.h"
#include "MeshBridge.h"
#include "SegmentationTransfer.h"
#include "SkeletonMap.h"
#include "SurfaceMeasures.h"
#include "TubeShapes.h"

#include <Eigen/LU>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace figures
{
namespace
{
using marrow::GhostBoundary;

/// A loop round a front leg of the source, and where it sits.
struct LegLoop
{
  marrow::SegmentLoop Loop;
  marrow::BoundaryTransfer::Seat Seat;
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
  marrow::SkeletonMap map(pair.SourceMesh, pair.TargetMesh, pair.Match);
  for (std::size_t c = 0; c < pair.Match.Chains.size(); ++c)
  {
    const marrow::ChainPair& chain = pair.Match.Chains[c];
    const marrow::TransferParameters defaults;
    const auto landmark = marrow::MatchGhostBoundaries(
      marrow::FindGhostBoundaries(pair.SourceMesh, chain.Source, defaults.Theta, defaults.Kernel),
      marrow::FindGhostBoundaries(pair.TargetMesh, chain.Target, defaults.Theta, defaults.Kernel));
    map.SetAlignment(static_cast<int>(c),
      marrow::AlignChains(pair.SourceMesh, chain.Source, pair.TargetMesh, chain.Target, landmark));
  }
  return map;
}

/// The boundary of the source's segment `label`.
LegLoop FindLoop(const Matched& pair, marrow::BoundaryTransfer& transfer, int label)
{
  const marrow::SegmentPieces pieces =
    marrow::FindPieces(pair.SourceMesh.Mesh, LabelsOf(pair.Source.Mesh));
  for (const marrow::SegmentLoop& loop : marrow::FindLoops(pair.SourceMesh.Mesh, pieces))
  {
    const auto seat = transfer.FindSeat(loop);
    if (seat &&
      (pieces.LabelOfPiece[loop.LeftPiece] == label ||
        pieces.LabelOfPiece[loop.RightPiece] == label))
    {
      return { loop, *seat };
    }
  }
  throw std::runtime_error("There is no such boundary that encloses a branch.");
}

std::vector<Eigen::Vector3d> PlacesOf(
  const marrow::TriangleMesh& mesh, const std::vector<int>& vertices)
{
  std::vector<Eigen::Vector3d> places;
  for (const int vertex : vertices)
  {
    places.push_back(mesh.Points[vertex]);
  }
  return places;
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
  const LegLoop leg = FindLoop(pair, transfer, label);
  auto cut =
    transfer.TransferByFrame(leg.Loop, leg.Seat, map.TargetRatio(leg.Seat.Chain, leg.Seat.Ratio));
  if (!cut)
  {
    throw std::runtime_error("The boundary has no annulus on the target.");
  }
  return { leg, *cut };
}

// Ghost boundaries

/// The limb with a pair of ghost boundaries whose tip is nearest to the eye (z).
const marrow::ChainPair& PairedLimb(const Matched& pair)
{
  const marrow::TransferParameters defaults;
  const marrow::ChainPair* best = nullptr;
  double nearest = -std::numeric_limits<double>::infinity();
  for (const marrow::ChainPair& chain : pair.Match.Chains)
  {
    const auto landmark = marrow::MatchGhostBoundaries(
      marrow::FindGhostBoundaries(pair.SourceMesh, chain.Source, defaults.Theta, defaults.Kernel),
      marrow::FindGhostBoundaries(pair.TargetMesh, chain.Target, defaults.Theta, defaults.Kernel));
    for (const int end : { chain.Source.Front(), chain.Source.Back() })
    {
      const double z = pair.SourceMesh.Skeleton.Graph[end].Position.z();
      if (landmark && z > nearest &&
        pair.SourceMesh.Skeleton.TypeOf(end) == marrow::NodeType::Terminal)
      {
        nearest = z;
        best = &chain;
      }
    }
  }
  if (!best)
  {
    throw std::runtime_error("No limb has a pair of ghost boundaries.");
  }
  return *best;
}

/// A camel, and its head and neck: the branch to the highest terminal.
struct CamelNeck
{
  explicit CamelNeck(const std::string& meshes)
    : Camel(Analyze(ReadMesh(meshes, "camel")))
  {
    double highest = -std::numeric_limits<double>::infinity();
    for (const marrow::Branch& branch : this->Camel.Skeleton.Branches)
    {
      for (const int end : { branch.Front(), branch.Back() })
      {
        const double height = this->Camel.Skeleton.Graph[end].Position.y();
        if (height > highest && this->Camel.Skeleton.TypeOf(end) == marrow::NodeType::Terminal)
        {
          highest = height;
          this->Neck = branch;
        }
      }
    }
  }

  marrow::AnalyzedMesh Camel;
  marrow::Branch Neck;
};

std::vector<Point> ProfileOf(
  const marrow::AnalyzedMesh& side, const marrow::Branch& chain, double kernel)
{
  const std::vector<double> values = marrow::GradientProfile(side, chain, kernel);
  std::vector<Point> profile;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    profile.push_back({ static_cast<double>(i) / (values.size() - 1), values[i] });
  }
  return profile;
}

double Highest(const std::vector<Point>& profile)
{
  double highest = 0.0;
  for (const Point& point : profile)
  {
    highest = std::max(highest, point[1]);
  }
  return highest;
}

double ValueAt(const std::vector<Point>& profile, double ratio)
{
  return profile[static_cast<std::size_t>(std::round(ratio * (profile.size() - 1)))][1];
}

/// The profile in its axes, with a disk at each peak that became a ghost boundary.
void DrawProfile(Canvas& canvas, Axes& axes, const std::vector<Point>& profile,
  const std::vector<GhostBoundary>& ghosts, const Color& color)
{
  axes.Curve(profile, color);
  for (const GhostBoundary& ghost : ghosts)
  {
    canvas.Disk(axes.At(ghost.Peak, ValueAt(profile, ghost.Peak)), 6, color);
  }
}

Picture DrawGhostProfile(const std::string&)
{
  const Matched& pair = Quadrupeds();
  const marrow::ChainPair& chain = PairedLimb(pair);
  const marrow::TransferParameters defaults;
  const std::vector<Point> profiles[2] = { ProfileOf(
                                             pair.SourceMesh, chain.Source, defaults.Kernel),
    ProfileOf(pair.TargetMesh, chain.Target, defaults.Kernel) };
  const std::vector<GhostBoundary> ghosts[2] = { marrow::FindGhostBoundaries(pair.SourceMesh,
                                                   chain.Source, defaults.Theta, defaults.Kernel),
    marrow::FindGhostBoundaries(pair.TargetMesh, chain.Target, defaults.Theta, defaults.Kernel) };
  const auto landmark = marrow::MatchGhostBoundaries(ghosts[0], ghosts[1]);
  Canvas canvas(760, 360);
  const double top = 1.1 * std::max(Highest(profiles[0]), Highest(profiles[1]));
  Axes axes(canvas, { 75, 55 }, { 740, 335 }, { 0, 0 }, { 1, top });
  axes.Frame("place along the branch (arc ratio)", "mean |MSP gradient|");
  if (landmark)
  {
    const auto ofRatio = [&](int side, double ratio)
    {
      for (const GhostBoundary& ghost : ghosts[side])
      {
        if (ghost.Ratio == ratio)
        {
          return axes.At(ghost.Peak, ValueAt(profiles[side], ghost.Peak));
        }
      }
      return axes.At(ratio, 0.0);
    };
    for (const Point& place : { ofRatio(0, landmark->Source), ofRatio(1, landmark->Target) })
    {
      canvas.Disk(place, 10, Black);
    }
  }
  DrawProfile(canvas, axes, profiles[0], ghosts[0], Blue);
  DrawProfile(canvas, axes, profiles[1], ghosts[1], Vermilion);
  canvas.Text({ 330, 322 }, "source", 15, Canvas::Align::Left, Blue);
  canvas.Text({ 330, 302 }, "target", 15, Canvas::Align::Left, Vermilion);
  canvas.Text({ 330, 282 }, "disks: peaks that stand out", 13, Canvas::Align::Left);
  canvas.Text({ 330, 264 }, "ringed: the pair taken for the same place", 13, Canvas::Align::Left);
  return canvas.Draw();
}

Data EdgesOf(const marrow::TriangleMesh& mesh, const std::vector<int>& halfEdges)
{
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> ends;
  for (const int h : halfEdges)
  {
    ends.emplace_back(mesh.Points[mesh.From(h)], mesh.Points[mesh.To(h)]);
  }
  return Segments(ends);
}

Picture DrawGhostBoundaries(const std::string&)
{
  const Matched& pair = Quadrupeds();
  const marrow::ChainPair& chain = PairedLimb(pair);
  const marrow::TransferParameters defaults;
  const auto scene = Scene(420, 320);
  const auto add = [&](const marrow::AnalyzedMesh& side, const marrow::Branch& branch,
                     const Prepared& shown, const char* caption, const Color& color)
  {
    // The skeletons are not seen but turn the target like the source.
    const int tile = scene->AddMesh(shown.Mesh, shown.Skeleton, caption);
    scene->SetSurfaceArray(tile, "MSPGradient");
    for (const GhostBoundary& ghost :
      marrow::FindGhostBoundaries(side, branch, defaults.Theta, defaults.Kernel))
    {
      scene->AddCurves(
        tile, EdgesOf(side.Mesh, ghost.HalfEdges), color[0], color[1], color[2], 0.005);
    }
  };
  add(pair.SourceMesh, chain.Source, pair.Source, "source", Vermilion);
  add(pair.TargetMesh, chain.Target, pair.Target, "target", Vermilion);
  return Drawn(scene);
}

Picture DrawTheta(const std::string& meshes)
{
  const CamelNeck camel(meshes);
  const marrow::TransferParameters defaults;
  const std::vector<Point> profile = ProfileOf(camel.Camel, camel.Neck, defaults.Kernel);
  std::vector<Picture> pictures;
  for (const char* theta : { "1.1", "1.5", "3" })
  {
    Canvas canvas(290, 240);
    Axes axes(canvas, { 65, 50 }, { 280, 205 }, { 0, 0 }, { 1, 1.1 * Highest(profile) });
    axes.Frame("arc ratio", "mean |MSP gradient|");
    DrawProfile(canvas, axes, profile,
      marrow::FindGhostBoundaries(camel.Camel, camel.Neck, std::stod(theta), defaults.Kernel),
      Blue);
    canvas.Text({ 172, 225 }, std::string("Theta ") + theta, 15);
    pictures.push_back(canvas.Draw());
  }
  return Beside(pictures);
}

Picture DrawKernel(const std::string& meshes)
{
  const CamelNeck camel(meshes);
  const marrow::TransferParameters defaults;
  std::vector<Picture> pictures;
  for (const char* kernel : { "0.01", "0.05", "0.2" })
  {
    Canvas canvas(290, 240);
    const double top = 1.1 * Highest(ProfileOf(camel.Camel, camel.Neck, 0.01));
    Axes axes(canvas, { 65, 50 }, { 280, 205 }, { 0, 0 }, { 1, top });
    axes.Frame("arc ratio", "mean |MSP gradient|");
    const double width = std::stod(kernel);
    DrawProfile(canvas, axes, ProfileOf(camel.Camel, camel.Neck, width),
      marrow::FindGhostBoundaries(camel.Camel, camel.Neck, defaults.Theta, width), Blue);
    canvas.Text({ 172, 225 }, std::string("Kernel ") + kernel, 15);
    pictures.push_back(canvas.Draw());
  }
  return Beside(pictures);
}

// Covering regions

/// The annulus of a mesh round a closed curve.
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
    throw std::runtime_error("There is no annulus round the boundary.");
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

// The snake

/// A tube with a groove at this fraction of its length, this deep.
marrow::test::Tube GroovedTube(double fraction, double depth)
{
  marrow::test::TubeOptions options;
  options.Around = 64;
  options.Along = 120;
  options.Bend = [=](const Eigen::Vector3d& p) -> Eigen::Vector3d
  {
    const double away = (p.z() / marrow::test::TubeOptions().Length + 0.5 - fraction) / 0.008;
    const double narrower = 1.0 - depth * std::exp(-away * away);
    return { narrower * p.x(), narrower * p.y(), p.z() };
  };
  marrow::test::Tube tube = marrow::test::MakeTube(options);
  tube.Analyzed.DihedralAngle = marrow::VertexDihedralAngles(tube.Analyzed.Mesh);
  return tube;
}

Data SurfaceOf(const marrow::AnalyzedMesh& analyzed)
{
  vtkNew<vtkPoints> points;
  for (const Eigen::Vector3d& point : analyzed.Mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : analyzed.Mesh.Triangles)
  {
    triangles->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto surface = Data::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  marrow::SetArray(surface->GetPointData(), "DihedralAngle", analyzed.DihedralAngle);
  return surface;
}

/// A tube whose boundary is its groove, and one whose groove lies elsewhere and is shallower.
struct GroovedTubes
{
  explicit GroovedTubes(double away)
    : Source(GroovedTube(0.5, 0.2))
    , Target(GroovedTube(0.5 + away, 0.18))
    , Match(marrow::test::MatchTubes(Source, Target))
    , Map(Source.Analyzed, Target.Analyzed, Match)
  {
    std::vector<int> labels;
    for (const double fraction : this->Source.Fraction)
    {
      labels.push_back(fraction > 0.5 ? 1 : 0);
    }
    this->Loop = marrow::FindLoops(
      this->Source.Analyzed.Mesh, marrow::FindPieces(this->Source.Analyzed.Mesh, labels))
                   .front();
  }

  /// The boundary on the target.
  std::vector<Eigen::Vector3d> Carry(double lambda, double searchRegion)
  {
    marrow::BoundaryTransfer transfer(this->Source.Analyzed, this->Target.Analyzed, this->Match,
      this->Map, { lambda, searchRegion });
    const auto seat = transfer.FindSeat(this->Loop);
    const auto cut = seat ? transfer.TransferByFrame(this->Loop, *seat, seat->Ratio) : std::nullopt;
    if (!cut)
    {
      throw std::runtime_error("The tube's boundary was not transferred.");
    }
    return cut->Curve.Points;
  }

  marrow::test::Tube Source;
  marrow::test::Tube Target;
  marrow::MatchedSkeletons Match;
  marrow::SkeletonMap Map;
  marrow::SegmentLoop Loop;
};

/// A tube's middle, coloured by its dihedral angles, with curves in black and purple.
class TubeScene
{
public:
  explicit TubeScene(int tileWidth)
    : Tiles(Scene(tileWidth, 260))
  {
    this->Tiles->SetViewUp(0, 0, 1);
    this->Tiles->SetViewDirection(1, 0, 0);
    this->Tiles->ShareRangeOn();
  }

  void Add(const marrow::AnalyzedMesh& tube, const std::string& caption,
    const std::vector<Eigen::Vector3d>& black, const std::vector<Eigen::Vector3d>& purple = {})
  {
    const Data surface = SurfaceOf(tube);
    const Data middle = Faces(surface,
      [&](vtkIdType face)
      { return std::abs(surface->GetPoint(surface->GetCell(face)->GetPointId(0))[2]) < 0.3; });
    const int tile = this->Tiles->AddMesh(middle, nullptr, caption.c_str());
    this->Tiles->SetSurfaceArray(tile, "DihedralAngle");
    this->Tiles->AddCurves(tile, ClosedLine(black), Black[0], Black[1], Black[2], 0.009);
    if (!purple.empty())
    {
      this->Tiles->AddCurves(tile, ClosedLine(purple), 0.65, 0.0, 0.65, 0.009);
    }
  }

  Picture Draw() { return Drawn(this->Tiles); }

private:
  vtkSmartPointer<vtkSideBySideScene> Tiles;
};

Picture DrawSnake(const std::string&)
{
  GroovedTubes tubes(0.0167);
  TubeScene scene(400);
  scene.Add(tubes.Source.Analyzed, "source: the boundary is the groove",
    PlacesOf(tubes.Source.Analyzed.Mesh, tubes.Loop.Vertices(tubes.Source.Analyzed.Mesh)));
  scene.Add(tubes.Target.Analyzed, "target: purple before, black after the snake",
    tubes.Carry(0.1, 0.02), tubes.Carry(0.1, 0.0));
  return scene.Draw();
}

Picture DrawSearchRegion(const std::string&)
{
  GroovedTubes tubes(0.0167);
  TubeScene scene(290);
  for (const char* region : { "0", "0.02", "0.1" })
  {
    scene.Add(tubes.Target.Analyzed, std::string("SearchRegion ") + region,
      tubes.Carry(0.1, std::stod(region)));
  }
  return scene.Draw();
}

Picture DrawLambda(const std::string&)
{
  GroovedTubes tubes(0.0083);
  TubeScene scene(290);
  for (const char* lambda : { "0.01", "0.1", "1" })
  {
    scene.Add(
      tubes.Target.Analyzed, std::string("Lambda ") + lambda, tubes.Carry(std::stod(lambda), 0.02));
  }
  return scene.Draw();
}
}

Drawings BoundaryFigures()
{
  return { { "ghost-profile", DrawGhostProfile }, { "ghost-boundaries", DrawGhostBoundaries },
    { "parameter-theta", DrawTheta }, { "parameter-kernel", DrawKernel },
    { "covering-region", DrawCoveringRegion }, { "snake", DrawSnake },
    { "parameter-search-region", DrawSearchRegion }, { "parameter-lambda", DrawLambda } };
}
}
