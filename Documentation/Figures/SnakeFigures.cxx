// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryTransfer.h"
#include "Figures.h"
#include "MeshBridge.h"
#include "SkeletonMap.h"
#include "SurfaceMeasures.h"
#include "TubeShapes.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <optional>
#include <stdexcept>

namespace figures
{
namespace
{
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
    , Map(Source.Analyzed, Target.Analyzed, Match,
        std::vector<marrow::ChainAlignment>(Match.Chains.size()))
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
    const auto seat = marrow::FindSeat(this->Source.Analyzed, this->Match, this->Loop);
    const auto cut = seat ? transfer.Transfer(this->Loop, *seat, seat->Ratio) : std::nullopt;
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
  vtkSmartPointer<vtkMarrowSideBySideScene> Tiles;
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

Drawings SnakeFigures()
{
  return { { "snake", DrawSnake }, { "parameter-search-region", DrawSearchRegion },
    { "parameter-lambda", DrawLambda } };
}
}
