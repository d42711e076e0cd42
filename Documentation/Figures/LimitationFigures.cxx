// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkPointData.h>
#include <vtkSegmentationTransfer.h>

namespace figures
{
namespace
{
/// What becomes of a creature's segments on an elephant of genus 3.
Picture DrawHandles(const std::string& meshes)
{
  const Matched pair =
    MatchCreatures(Creature(vtkCreatureSource::QUADRUPED, 1), ReadMesh(meshes, "elephant"));
  const auto skeletons = Scene(330, 240);
  skeletons->SetSurfaceOpacity(0.2);
  skeletons->SetColorSkeletonBy(vtkMarrowSkeletonGlyphs::CORRESPONDENCE);
  skeletons->SetLabelArrayName("");
  skeletons->AddMesh(pair.Source.Mesh, pair.Source.Skeleton, "skeletons");
  skeletons->AddMesh(pair.Target.Mesh, pair.Target.Skeleton);
  const auto segments = Scene(330, 240);
  segments->AlignOff();
  segments->AddMesh(pair.Source.Mesh, nullptr, "source");
  segments->AddMesh(Transfer(pair.Source, pair.Target).Target, nullptr, "segments");
  return Below({ Drawn(skeletons), Drawn(segments) });
}

/// A camel's limbs on a diplodocus.
Picture DrawTailForLeg(const std::string& meshes)
{
  return DrawMatch(
    Prepare(ReadMesh(meshes, "camel")), Prepare(ReadMesh(meshes, "diplodocus")), 310, 280, "camel");
}

/// The arms of an octopus look all alike.
Picture DrawSymmetry(const std::string&)
{
  const Data source = Creature(vtkCreatureSource::OCTOPUS, 1);
  const Data target = Creature(vtkCreatureSource::OCTOPUS, 2, 0.6, 0.4);
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source);
  transfer->SetInputData(1, target);
  transfer->Update();
  const auto scene = Scene(290, 260);
  scene->AlignOff();
  scene->SetElevation(50);
  scene->AddMesh(source, nullptr, "source");
  scene->AddMesh(Output(transfer), nullptr, "target");
  scene->AddMesh(target, nullptr, "as it was made");
  return Drawn(scene);
}

/// An elephant with holes: vertices without a closed slice, and the skeleton.
Picture DrawOpenMesh(const std::string& meshes)
{
  const Prepared open = Prepare(ReadMesh(meshes, "elephant-with-holes"));
  vtkNew<vtkIntArray> valid;
  valid->SetName("SegmentId");
  vtkDataArray* closed = open.Mesh->GetPointData()->GetArray("MSPValid");
  for (vtkIdType face = 0; face < open.Mesh->GetNumberOfCells(); ++face)
  {
    valid->InsertNextValue(closed->GetTuple1(open.Mesh->GetCell(face)->GetPointId(0)) != 0 ? 6 : 1);
  }
  open.Mesh->GetCellData()->AddArray(valid);
  const auto scene = Scene(340, 310);
  scene->AddMesh(open.Mesh, nullptr, "blue: the slice is closed");
  scene->SetTileOpacity(scene->AddMesh(Plain(open.Mesh), open.Skeleton, "skeleton"), 0.2);
  return Drawn(scene);
}
}

Drawings LimitationFigures()
{
  return { { "limitation-handles", DrawHandles }, { "limitation-tail-for-leg", DrawTailForLeg },
    { "limitation-symmetry", DrawSymmetry }, { "limitation-open-mesh", DrawOpenMesh } };
}
}
