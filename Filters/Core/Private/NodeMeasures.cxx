// SPDX-License-Identifier: BSD-3-Clause
#include "NodeMeasures.h"

#include <algorithm>
#include <utility>

namespace marrow
{
void AverageMeasures(Skeleton& skeleton, const TriangleMesh& mesh, const VertexMeasures& measures)
{
  skeleton.MeshDiagonal = mesh.BoundingBoxDiagonal();
  skeleton.MeshMaximumMSP = *std::max_element(measures.MSP.begin(), measures.MSP.end());

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
