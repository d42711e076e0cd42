// SPDX-License-Identifier: BSD-3-Clause
#include "BorderClosing.h"

namespace marrow
{
ClosedMesh CloseBorders(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& position,
  const std::vector<double>& msp)
{
  ClosedMesh closed{ mesh, position, msp };
  std::vector<char> seen(mesh.Opposite.size(), 0);
  bool added = false;
  for (int h = 0; h < static_cast<int>(mesh.Opposite.size()); ++h)
  {
    if (mesh.Opposite[h] >= 0 || seen[h])
    {
      continue;
    }
    const int middle = closed.Mesh.NumberOfVertices();
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d shrunk = Eigen::Vector3d::Zero();
    double perimeter = 0.0;
    int count = 0;
    for (int walk = h; !seen[walk]; walk = mesh.Outgoing[mesh.To(walk)])
    {
      seen[walk] = 1;
      closed.Mesh.Triangles.push_back({ mesh.To(walk), mesh.From(walk), middle });
      point += mesh.Points[mesh.From(walk)];
      shrunk += position[mesh.From(walk)];
      perimeter += msp[mesh.From(walk)];
      ++count;
    }
    closed.Mesh.Points.push_back(point / count);
    closed.Position.push_back(shrunk / count);
    closed.MSP.push_back(perimeter / count);
    added = true;
  }
  if (added)
  {
    closed.Mesh.BuildConnectivity();
  }
  return closed;
}
}
