// SPDX-License-Identifier: BSD-3-Clause
#include "Creature.h"
#include "Figures.h"
#include "ImplicitCreature.h"
#include "MeshRelaxation.h"
#include "SurfaceNets.h"
#include "TestMeshes.h"

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
  return marrow::test::ToPolyData(contour);
}

/// Arms matched that end in the thighs, and what the transfer makes of them.
Picture DrawHandsOnThighs(const std::string&)
{
  const Prepared source = Prepare(Creature(vtkCreatureSource::BIPED, 1));
  const Prepared target = Prepare(HandsOnThighs());
  const auto segments = Scene(190, 300);
  segments->AlignOff();
  segments->SetViewDirection(1.0, 0.0, 0.0);
  segments->AddMesh(source.Mesh, nullptr, "source");
  segments->AddMesh(Transfer(source, target).Target, nullptr, "target");
  return Beside({ DrawMatch(source, target, 190, 300, "skeletons"), Drawn(segments) });
}
}

Drawings LoopFigures()
{
  return { { "opened-loops", DrawHandsOnThighs } };
}
}
