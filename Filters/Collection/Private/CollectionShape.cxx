// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionShape.h"

#include "ContentKey.h"
#include "DenseMap.h"

namespace marrow
{
namespace
{
std::string KeyOf(const AnalyzedMesh& shape)
{
  ContentKey key;
  for (const Eigen::Vector3d& point : shape.Mesh.Points)
  {
    key.Add(point.data(), 3 * sizeof(double));
  }
  for (const auto& triangle : shape.Mesh.Triangles)
  {
    key.Add(triangle.data(), sizeof(triangle));
  }
  key.Add(shape.MSP.data(), shape.MSP.size() * sizeof(double));
  key.Add(shape.NodeOfVertex.data(), shape.NodeOfVertex.size() * sizeof(int));
  for (int node = 0; node < shape.Skeleton.NumberOfNodes(); ++node)
  {
    key.Add(shape.Skeleton.Graph[node].Position.data(), 3 * sizeof(double));
  }
  for (const Branch& branch : shape.Skeleton.Branches)
  {
    key.Add(branch.Nodes.data(), branch.Nodes.size() * sizeof(int));
  }
  return key.Text();
}
}

CollectionShape::CollectionShape(const AnalyzedMesh& fine)
  : Fine(fine)
  , Coarse(Coarsen(fine))
  , Key(KeyOf(fine))
{
}

std::shared_ptr<const SourceSearch> CollectionShape::GetFineSearch() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->FineSearch)
  {
    this->FineSearch = std::make_shared<SourceSearch>(this->Fine, std::vector<bool>());
  }
  return this->FineSearch;
}

std::shared_ptr<const SourceSearch> CollectionShape::GetCoarseSearch() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->CoarseSearch)
  {
    this->CoarseSearch = std::make_shared<SourceSearch>(this->Coarse.Side, std::vector<bool>());
  }
  return this->CoarseSearch;
}

std::shared_ptr<const MeshSmoother> CollectionShape::GetCoarseSmoother() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->CoarseSmoother)
  {
    this->CoarseSmoother = DenseMapper::SmootherOf(this->Coarse.Side);
  }
  return this->CoarseSmoother;
}
}
