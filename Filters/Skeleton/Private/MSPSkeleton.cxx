// SPDX-License-Identifier: BSD-3-Clause
#include "MSPSkeleton.h"

#include "BorderClosing.h"
#include "BranchResampling.h"
#include "EdgeCollapse.h"
#include "InteriorNodes.h"
#include "ShrunkMesh.h"
#include "SpurPruning.h"

#include <algorithm>

namespace marrow
{
namespace
{
/// With fewer vertices than these to a node a ring is no ring any more.
constexpr double LeastVerticesPerNode = 8.0;

/// Removes the vertices that only close the borders from φ.
void KeepOwnVertices(Skeleton& skeleton, int numberOfVertices)
{
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    auto& vertices = skeleton.Graph[n].Vertices;
    vertices.erase(
      std::lower_bound(vertices.begin(), vertices.end(), numberOfVertices), vertices.end());
  }
}
}

Skeleton ComputeMSPSkeleton(const TriangleMesh& mesh, const SkeletonMeasures& measures,
  double finestArea, double spacing, const Progress& progress)
{
  const std::vector<Eigen::Vector3d> shrunk =
    ShrinkMesh(mesh, measures.MSP, measures.MSPCenter, measures.MSPValid);
  std::vector<double> weight = SliceReliability(mesh, measures.MSP, measures.MSPValid);
  const std::vector<double> area = mesh.VertexAreas();
  for (std::size_t v = 0; v < weight.size(); ++v)
  {
    weight[v] *= area[v];
  }
  if (!Report(progress, 0.3))
  {
    return {};
  }

  const ClosedMesh closed = CloseBorders(mesh, shrunk, measures.MSP);
  Skeleton skeleton;
  skeleton.Graph =
    CollapseToGraph(closed.Mesh, closed.Position, closed.MSP, SubProgress(progress, 0.3, 0.8));
  if (skeleton.NumberOfNodes() == 0)
  {
    return {};
  }
  KeepOwnVertices(skeleton, mesh.NumberOfVertices());
  CenterNodes(skeleton, shrunk, weight);
  skeleton.ExtractBranches();

  PruneSpurs(skeleton, mesh, measures.MSP, finestArea);
  if (!Report(progress, 0.9))
  {
    return {};
  }
  const double coarsest =
    skeleton.TotalLength() * LeastVerticesPerNode / std::max(1, mesh.NumberOfVertices());
  skeleton = ResampleBranches(skeleton, mesh, shrunk, weight, std::max(spacing, coarsest));
  SmoothBranches(skeleton, weight, measures.MSP);
  ExtendTerminals(skeleton, mesh);
  MoveNodesInside(skeleton, mesh);
  AverageMeasures(skeleton, mesh, measures);
  skeleton.MeshDiagonal = mesh.BoundingBoxDiagonal();
  skeleton.MeshMaximumMSP = *std::max_element(measures.MSP.begin(), measures.MSP.end());
  Report(progress, 1.0);
  return skeleton;
}

void AverageMeasures(Skeleton& skeleton, const TriangleMesh& mesh, const SkeletonMeasures& measures)
{
  const int numberOfNodes = skeleton.NumberOfNodes();
  std::vector<int> empty;
  for (int n = 0; n < numberOfNodes; ++n)
  {
    SkeletonNode& node = skeleton.Graph[n];
    if (node.Vertices.empty())
    {
      empty.push_back(n);
      continue;
    }
    node.AGD = node.MSP = node.Radius = 0.0;
    for (const int v : node.Vertices)
    {
      node.AGD += measures.AGD[v];
      node.MSP += measures.MSP[v];
      node.Radius += (mesh.Points[v] - node.Position).norm();
    }
    const double count = static_cast<double>(node.Vertices.size());
    node.AGD /= count;
    node.MSP /= count;
    node.Radius /= count;
  }
  // From the ends of a gap inwards; every round fills at least one node of each gap.
  while (!empty.empty())
  {
    std::vector<int> left;
    std::vector<std::pair<int, SkeletonNode>> filled;
    for (const int n : empty)
    {
      SkeletonNode mean = skeleton.Graph[n];
      mean.AGD = mean.MSP = mean.Radius = 0.0;
      int count = 0;
      for (auto [a, end] = boost::adjacent_vertices(n, skeleton.Graph); a != end; ++a)
      {
        if (std::find(empty.begin(), empty.end(), static_cast<int>(*a)) == empty.end())
        {
          mean.AGD += skeleton.Graph[*a].AGD;
          mean.MSP += skeleton.Graph[*a].MSP;
          mean.Radius += skeleton.Graph[*a].Radius;
          ++count;
        }
      }
      if (count == 0)
      {
        left.push_back(n);
        continue;
      }
      mean.AGD /= count;
      mean.MSP /= count;
      mean.Radius /= count;
      filled.emplace_back(n, std::move(mean));
    }
    if (filled.empty())
    {
      return;
    }
    for (auto& [n, node] : filled)
    {
      skeleton.Graph[n] = std::move(node);
    }
    empty = std::move(left);
  }
}
}
