// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyzedMesh.h"

#include "MeshPaths.h"

namespace marrow
{
void FillNodeOfVertex(const TriangleMesh& mesh, std::vector<int>& nodeOfVertex)
{
  std::vector<int> seeds;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (nodeOfVertex[v] >= 0)
    {
      seeds.push_back(v);
    }
  }
  const PathField field = DistanceField(mesh, seeds);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (nodeOfVertex[v] < 0 && field.Origin[v] >= 0)
    {
      nodeOfVertex[v] = nodeOfVertex[field.Origin[v]];
    }
  }
}
}
