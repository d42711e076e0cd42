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

Skeleton ComputeMSPSkeleton(const TriangleMesh& mesh, const VertexMeasures& measures,
  double finestArea, double spacing, const Progress& progress)
{
  std::vector<double> weight = SliceReliability(mesh, measures.MSP, measures.MSPValid);
  const std::vector<Eigen::Vector3d> shrunk =
    ShrinkMesh(mesh, measures.MSP, measures.MSPCenter, weight);
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

  const std::vector<int> removedLimb = PruneSpurs(skeleton, mesh, shrunk, measures.MSP, finestArea);
  for (std::size_t v = 0; v < weight.size(); ++v)
  {
    // A removed limb would draw the line that is left towards itself.
    weight[v] = removedLimb[v] < 0 ? weight[v] : 0.0;
  }
  if (!Report(progress, 0.9))
  {
    return {};
  }
  const double coarsest =
    skeleton.TotalLength() * LeastVerticesPerNode / std::max(1, mesh.NumberOfVertices());
  skeleton =
    ResampleBranches(skeleton, mesh, shrunk, weight, removedLimb, std::max(spacing, coarsest));
  SmoothBranches(skeleton, weight, measures.MSP);
  ExtendTerminals(skeleton, mesh, removedLimb);
  MoveNodesInside(skeleton, mesh);
  AverageMeasures(skeleton, mesh, measures);
  Report(progress, 1.0);
  return skeleton;
}
}
