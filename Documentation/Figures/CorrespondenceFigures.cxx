// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"
#include "LeafSelection.h"
#include "SkeletonBridge.h"
#include "TreeDrawing.h"

#include <vtkFieldData.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkSkeletonCorrespondence.h>

#include <cstdio>

namespace figures
{
Picture DrawMatch(const Prepared& source, const Prepared& target, int tileWidth, int tileHeight,
  const std::string& caption, const CorrespondenceSettings& set)
{
  vtkNew<vtkSkeletonCorrespondence> correspondence;
  correspondence->SetInputData(0, source.Skeleton);
  correspondence->SetInputData(1, target.Skeleton);
  set(correspondence);
  correspondence->Update();
  const Data matched[2] = { Output(correspondence, 0), Output(correspondence, 1) };
  const auto scene = Scene(tileWidth, tileHeight);
  scene->SetSurfaceOpacity(0.15);
  scene->SetLabelArrayName("");
  scene->SetColorSkeletonBy(vtkMarrowSkeletonGlyphs::CORRESPONDENCE);
  scene->ShowLinksOn();
  const double confidence =
    matched[0]->GetFieldData()->GetArray("CorrespondenceConfidence")->GetTuple1(0);
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", confidence);
  scene->AddMesh(source.Mesh, matched[0], caption.empty() ? nullptr : caption.c_str());
  scene->AddMesh(target.Mesh, matched[1], ("confidence " + std::string(text)).c_str());
  return Drawn(scene);
}

namespace
{
/// A biped, and one that is bent so that its shoulders have a junction of their own.
const std::pair<Prepared, Prepared>& Bipeds()
{
  static const std::pair<Prepared, Prepared> bipeds = { Prepare(
                                                          Creature(vtkCreatureSource::BIPED, 1)),
    Prepare(Creature(vtkCreatureSource::BIPED, 1, 0.6)) };
  return bipeds;
}

Picture DrawCorrespondence(const std::string& meshes)
{
  return DrawMatch(
    Prepare(ReadMesh(meshes, "camel")), Prepare(ReadMesh(meshes, "cow")), 340, 310, "source");
}

Picture DrawTree(const std::string&)
{
  marrow::Skeleton source;
  marrow::Skeleton target;
  marrow::ToSkeleton(Bipeds().first.Skeleton, source);
  marrow::ToSkeleton(Bipeds().second.Skeleton, target);
  const marrow::FeatureGraph sourceGraph(source, 8);
  const marrow::FeatureGraph targetGraph(target, 8);
  marrow::CorrespondenceTree tree(sourceGraph, targetGraph, marrow::TreeParameters());
  tree.Grow({});
  constexpr bool global = true;
  std::vector<marrow::RatedLeaf> leaves;
  for (marrow::RatedLeaf& leaf :
    marrow::RateLeaves(sourceGraph, targetGraph, tree.GetLeaves(), {}, global))
  {
    if (!leaf.Refined)
    {
      leaves.push_back(std::move(leaf));
    }
  }
  return DrawCorrespondenceTree(source, sourceGraph, target, targetGraph, leaves);
}

Picture DrawLeafIndex(const std::string&)
{
  std::vector<Picture> pictures;
  for (const int leaf : { 0, 1, 4 })
  {
    pictures.push_back(
      DrawMatch(Bipeds().first, Bipeds().second, 145, 270, "leaf " + std::to_string(leaf),
        [&](vtkSkeletonCorrespondence* c) { c->SetLeafIndex(leaf); }));
  }
  return Beside(pictures);
}

Picture DrawMergeDistance(const std::string&)
{
  std::vector<Picture> pictures;
  for (const char* distance : { "0", "0.075" })
  {
    pictures.push_back(
      DrawMatch(Bipeds().first, Bipeds().second, 215, 330, std::string("MergeDistance ") + distance,
        [&](vtkSkeletonCorrespondence* c)
        {
          c->SetMergeDistance(std::stod(distance));
          c->GlobalSelectionOff();
        }));
  }
  return Beside(pictures);
}

Picture DrawGlobalSelection(const std::string& meshes)
{
  const Prepared source = Prepare(ReadMesh(meshes, "camel"));
  const Prepared target = Prepare(ReadMesh(meshes, "triceratops"));
  std::vector<Picture> pictures;
  for (const bool global : { true, false })
  {
    pictures.push_back(
      DrawMatch(source, target, 300, 220, std::string("GlobalSelection ") + (global ? "on" : "off"),
        [&](vtkSkeletonCorrespondence* c) { c->SetGlobalSelection(global); }));
  }
  return Below(pictures);
}

Picture DrawMatcher(const std::string& meshes)
{
  const Prepared source = Prepare(ReadMesh(meshes, "camel"));
  const Prepared target = Prepare(ReadMesh(meshes, "bull"));
  return Beside({ DrawMatch(source, target, 215, 210, "tree",
                    [](vtkSkeletonCorrespondence* c) { c->SetMatcherToCorrespondenceTree(); }),
    DrawMatch(source, target, 215, 210, "voting",
      [](vtkSkeletonCorrespondence* c) { c->SetMatcherToElectorsVoting(); }) });
}
}

Drawings CorrespondenceFigures()
{
  return { { "correspondence", DrawCorrespondence }, { "correspondence-tree", DrawTree },
    { "parameter-leaf-index", DrawLeafIndex }, { "parameter-merge-distance", DrawMergeDistance },
    { "parameter-global-selection", DrawGlobalSelection }, { "parameter-matcher", DrawMatcher } };
}
}
