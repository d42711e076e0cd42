// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include <vtkCellData.h>
#include <vtkSegmentationTransfer.h>

namespace figures
{
namespace
{
void AddBoundaries(vtkMarrowSideBySideScene* scene, int tile, vtkPolyData* boundaries)
{
  scene->AddCurves(tile, boundaries, Black[0], Black[1], Black[2], 0.003);
}

Picture DrawTransfer(const std::string&)
{
  const Matched& pair = Quadrupeds();
  const Transferred result = Transfer(pair.Source, pair.Target);
  const auto scene = Scene(390, 310);
  AddBoundaries(
    scene, scene->AddMesh(pair.Source.Mesh, nullptr, "source"), result.SourceBoundaries);
  AddBoundaries(scene, scene->AddMesh(result.Target, nullptr, "target"), result.TargetBoundaries);
  return Drawn(scene);
}

Picture DrawConfidence(const std::string&)
{
  const Transferred result = Transfer(Quadrupeds().Source, Quadrupeds().Target);
  const auto scene = Scene(390, 310);
  scene->AddMesh(result.Target, nullptr, "segments");
  scene->SetSurfaceArray(scene->AddMesh(result.Target, nullptr, "how sure"), "SegmentConfidence");
  return Drawn(scene);
}

/// A quadruped with a saddle, whose boundary encloses no branch.
Data Saddled()
{
  const Data mesh = Creature(vtkCreatureSource::QUADRUPED, 1);
  vtkDataArray* segments = mesh->GetCellData()->GetArray("SegmentId");
  for (vtkIdType face = 0; face < mesh->GetNumberOfCells(); ++face)
  {
    double box[6];
    mesh->GetCellBounds(face, box);
    const Eigen::Vector3d center(
      0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
    if ((center - Eigen::Vector3d(0.05, 1.25, 0.0)).norm() < 0.36)
    {
      segments->SetTuple1(face, 8);
    }
  }
  return mesh;
}

Picture DrawStrictBoundaries(const std::string&)
{
  const Matched pair =
    MatchCreatures(Saddled(), Creature(vtkCreatureSource::QUADRUPED, 7, 0.5, 0.5));
  const auto scene = Scene(290, 250);
  scene->AddMesh(pair.Source.Mesh, nullptr, "source");
  for (const bool strict : { false, true })
  {
    const Transferred result = Transfer(pair.Source, pair.Target,
      [&](vtkSegmentationTransfer* t) { t->SetStrictBoundaries(strict); });
    scene->AddMesh(result.Target, nullptr, strict ? "StrictBoundaries on" : "StrictBoundaries off");
  }
  return Drawn(scene);
}
}

Drawings TransferFigures()
{
  return { { "transfer", DrawTransfer }, { "confidence", DrawConfidence },
    { "parameter-strict-boundaries", DrawStrictBoundaries } };
}
}
