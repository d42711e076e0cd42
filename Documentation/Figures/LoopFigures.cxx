// SPDX-License-Identifier: BSD-3-Clause
#include "Creature.h"
#include "Figures.h"
#include "ImplicitCreature.h"
#include "MeshRelaxation.h"
#include "SurfaceNets.h"

#include <vtkCellArray.h>
#include <vtkSegmentationTransfer.h>

namespace figures
{
namespace
{
/// A biped whose hands have grown to the thighs.
Data HandsOnThighs()
{
  marrow::Variation proportion(1, 1, 0.0);
  marrow::Variation pose(1, 1, 0.0);
  marrow::Creature person = marrow::MakeCreature(marrow::CreatureKind::Biped, proportion, pose);
  constexpr int rightArm = 3;
  for (int arm = rightArm; arm < rightArm + 2; ++arm)
  {
    std::vector<marrow::Joint>& joints = person.Limbs[arm].Joints;
    const double side = arm == rightArm ? 1.0 : -1.0;
    joints[2].Position = { -0.04, 1.22, side * 0.46 };
    joints[3].Position = { 0.02, 0.95, side * 0.42 };
    joints[4].Position = { 0.04, 0.78, side * 0.27 };
  }
  const marrow::ImplicitCreature surface(person);
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  surface.Bounds(low, high);
  const double spacing = (high - low).norm() / 100.0;
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(2.0 * spacing);
  marrow::TriangleMesh contour =
    marrow::SurfaceNets([&](const Eigen::Vector3d& point) { return surface.Value(point); },
      low - margin, high + margin, spacing);
  marrow::RelaxMesh(
    contour, [&](const Eigen::Vector3d& point) { return surface.Project(point); }, 6);

  vtkNew<vtkPoints> points;
  for (const Eigen::Vector3d& point : contour.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : contour.Triangles)
  {
    triangles->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  const auto mesh = Data::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

/// Arms matched that end in the thighs, and what the transfer makes of them.
Picture DrawHandsOnThighs(const std::string&)
{
  const Prepared source = Prepare(Creature(vtkCreatureSource::BIPED, 1));
  const Prepared target = Prepare(HandsOnThighs());
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source.Mesh);
  transfer->SetInputData(1, target.Mesh);
  transfer->SetInputData(2, source.Skeleton);
  transfer->SetInputData(3, target.Skeleton);
  transfer->Update();
  const auto segments = Scene(190, 300);
  segments->AlignOff();
  segments->SetViewDirection(1.0, 0.0, 0.0);
  segments->AddMesh(source.Mesh, nullptr, "source");
  segments->AddMesh(Output(transfer), nullptr, "target");
  return Beside({ DrawMatch(source, target, 190, 300, "skeletons"), Drawn(segments) });
}
}

Drawings LoopFigures()
{
  return { { "opened-loops", DrawHandsOnThighs } };
}
}
