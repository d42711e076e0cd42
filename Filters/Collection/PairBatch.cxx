// SPDX-License-Identifier: BSD-3-Clause
#include "PairBatch.h"

#include "DenseMap.h"
#include "ParallelFor.h"

#include <map>
#include <memory>

namespace marrow
{
PairBatch::PairBatch(const std::vector<CollectionMember>& members, std::string folder)
  : Members(members)
  , Folder(std::move(folder))
{
}

bool PairBatch::Collect(const std::vector<PairEnds>& ends, const Progress& progress)
{
  std::map<int, std::shared_ptr<const CollectedMesh>> meshes;
  for (const PairEnds& of : ends)
  {
    meshes[of[0].first] = nullptr;
    meshes[of[1].first] = nullptr;
  }
  std::vector<vtkPolyData*> toPrepare;
  for (const auto& [member, none] : meshes)
  {
    toPrepare.push_back(this->Members[member].Mesh);
  }
  std::vector<std::shared_ptr<const CollectedMesh>> prepared;
  constexpr double afterMeshes = 0.2; // of the progress
  if (!this->Meshes.Collect(toPrepare, prepared, SubProgress(progress, 0.0, afterMeshes)))
  {
    return false;
  }
  std::size_t next = 0;
  for (auto& [member, mesh] : meshes)
  {
    mesh = prepared[next++];
  }
  this->Ends.clear();
  for (const PairEnds& of : ends)
  {
    const auto shapeOf = [&](const std::pair<int, int>& end) -> ShapePair::Shape
    {
      const auto& mesh = meshes.at(end.first);
      return { mesh, mesh->Shapes[end.second].get() };
    };
    this->Ends.emplace_back(shapeOf(of[0]), shapeOf(of[1]));
  }
  return this->Known.Collect(
    this->Ends, this->Folder, this->Pairs, SubProgress(progress, afterMeshes, 1.0));
}

void PairBatch::Carry(const std::vector<WantedMaps>& wanted)
{
  // One smoother serves all maps of a shape.
  std::map<const CollectionShape*, std::shared_ptr<const MeshSmoother>> smoothers;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    for (const auto& [side, answer] : wanted[i].OfAnswers)
    {
      smoothers[&this->ShapeOf(i, side)] = nullptr;
    }
  }
  std::vector<const CollectionShape*> smoothed;
  for (const auto& [shape, none] : smoothers)
  {
    smoothed.push_back(shape);
  }
  ParallelFor(0, static_cast<int>(smoothed.size()),
    [&](int first, int last)
    {
      for (int i = first; i < last; ++i)
      {
        smoothers.at(smoothed[i]) = DenseMapper::SmootherOf(smoothed[i]->Fine);
      }
    });
  ParallelFor(0, static_cast<int>(wanted.size()),
    [&](int first, int last)
    {
      for (int i = first; i < last; ++i)
      {
        for (const auto& [side, answer] : wanted[i].OfAnswers)
        {
          this->Pairs[i]->Carry(side, answer, smoothers.at(&this->ShapeOf(i, side)), {});
        }
      }
    });
  this->Known.Save(this->Folder);
}
}
