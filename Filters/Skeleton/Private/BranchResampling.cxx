// SPDX-License-Identifier: BSD-3-Clause
#include "BranchResampling.h"

#include "PatchConnectivity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
/// How far along the old branch, in nodes, a vertex may move from the node it was collapsed to: a
/// branch that bends back on itself must not swap its rings.
constexpr int Reach = 3;
/// The terminal's place between the middle of its cap and the tip: inside, and close to the end.
constexpr double TowardsTip = 0.6;

struct Projection
{
  double SquaredDistance = std::numeric_limits<double>::infinity();
  double Arc = 0.0;
};

Projection Project(const Eigen::Vector3d& point, const Skeleton& skeleton, const Branch& branch,
  int firstSegment, int lastSegment)
{
  Projection best;
  for (int i = firstSegment; i <= lastSegment; ++i)
  {
    const Eigen::Vector3d& a = skeleton.Graph[branch.Nodes[i]].Position;
    const Eigen::Vector3d d = skeleton.Graph[branch.Nodes[i + 1]].Position - a;
    const double squaredLength = d.squaredNorm();
    const double t =
      squaredLength > 0.0 ? std::clamp((point - a).dot(d) / squaredLength, 0.0, 1.0) : 0.0;
    const double squaredDistance = (a + t * d - point).squaredNorm();
    if (squaredDistance < best.SquaredDistance)
    {
      best.SquaredDistance = squaredDistance;
      best.Arc = branch.ArcLength[i] + t * (branch.ArcLength[i + 1] - branch.ArcLength[i]);
    }
  }
  return best;
}

Eigen::Vector3d PointAt(const Skeleton& skeleton, const Branch& branch, double arc)
{
  const auto upper = std::upper_bound(branch.ArcLength.begin(), branch.ArcLength.end(), arc);
  const int i = std::clamp(static_cast<int>(upper - branch.ArcLength.begin()) - 1, 0,
    static_cast<int>(branch.Nodes.size()) - 2);
  const double length = branch.ArcLength[i + 1] - branch.ArcLength[i];
  const double t = length > 0.0 ? (arc - branch.ArcLength[i]) / length : 0.0;
  const Eigen::Vector3d& a = skeleton.Graph[branch.Nodes[i]].Position;
  return a + t * (skeleton.Graph[branch.Nodes[i + 1]].Position - a);
}

/// The resampled branches: which new node stands at which step of which old branch.
class Resampling
{
public:
  Resampling(const Skeleton& old, double spacing)
    : Old(old)
    , NewFeature(old.NumberOfNodes(), -1)
  {
    for (const Branch& branch : old.Branches)
    {
      const int least = branch.IsLoop() ? 3 : 1;
      const int steps =
        std::max(least, static_cast<int>(std::lround(branch.Length() / spacing)));
      std::vector<int> nodes(1, this->Feature(branch.Front()));
      for (int i = 1; i < steps; ++i)
      {
        SkeletonNode node;
        node.Position = PointAt(old, branch, branch.Length() * i / steps);
        nodes.push_back(static_cast<int>(boost::add_vertex(node, this->New.Graph)));
      }
      nodes.push_back(this->Feature(branch.Back()));
      for (int i = 0; i < steps; ++i)
      {
        boost::add_edge(nodes[i], nodes[i + 1], this->New.Graph);
      }
      this->NodesOfBranch.push_back(std::move(nodes));
    }
  }

  int NodeAt(int branch, double arc) const
  {
    const auto& nodes = this->NodesOfBranch[branch];
    const int steps = static_cast<int>(nodes.size()) - 1;
    const double length = this->Old.Branches[branch].Length();
    const int step =
      length > 0.0 ? static_cast<int>(std::lround(arc / length * steps)) : 0;
    return nodes[std::clamp(step, 0, steps)];
  }

  Skeleton New;

private:
  int Feature(int oldNode)
  {
    if (this->NewFeature[oldNode] < 0)
    {
      SkeletonNode node;
      node.Position = this->Old.Graph[oldNode].Position;
      this->NewFeature[oldNode] = static_cast<int>(boost::add_vertex(node, this->New.Graph));
    }
    return this->NewFeature[oldNode];
  }

  const Skeleton& Old;
  std::vector<int> NewFeature;
  std::vector<std::vector<int>> NodesOfBranch;
};
}

Skeleton ResampleBranches(const Skeleton& skeleton, const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& shrunk, const std::vector<double>& weight, double spacing)
{
  Resampling resampling(skeleton, spacing);

  std::vector<int> nodeOfVertex(mesh.Points.size(), -1);
  std::vector<double> squaredDistance(
    mesh.Points.size(), std::numeric_limits<double>::infinity());
  for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
  {
    const Branch& branch = skeleton.Branches[b];
    const int lastSegment = static_cast<int>(branch.Nodes.size()) - 2;
    for (int i = 0; i <= lastSegment + 1; ++i)
    {
      for (const int v : skeleton.Graph[branch.Nodes[i]].Vertices)
      {
        // The φ of a junction is seen once from each of its branches: the nearest takes the vertex.
        const Projection projection = Project(shrunk[v], skeleton, branch,
          std::max(0, i - Reach), std::min(lastSegment, i + Reach - 1));
        if (projection.SquaredDistance < squaredDistance[v])
        {
          squaredDistance[v] = projection.SquaredDistance;
          nodeOfVertex[v] = resampling.NodeAt(b, projection.Arc);
        }
      }
    }
  }
  JoinStrayPieces(mesh, nodeOfVertex);

  Skeleton result = std::move(resampling.New);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (nodeOfVertex[v] >= 0)
    {
      result.Graph[nodeOfVertex[v]].Vertices.push_back(v);
    }
  }
  CenterNodes(result, shrunk, weight);
  result.ExtractBranches();
  return result;
}

void CenterNodes(Skeleton& skeleton, const std::vector<Eigen::Vector3d>& shrunk,
  const std::vector<double>& weight)
{
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    SkeletonNode& node = skeleton.Graph[n];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0.0;
    for (const int v : node.Vertices)
    {
      sum += weight[v] * shrunk[v];
      total += weight[v];
    }
    if (total > 0.0)
    {
      node.Position = sum / total;
    }
  }
}

void ExtendTerminals(Skeleton& skeleton, const TriangleMesh& mesh)
{
  for (const Branch& branch : skeleton.Branches)
  {
    for (const bool atFront : { true, false })
    {
      const int terminal = atFront ? branch.Front() : branch.Back();
      if (skeleton.TypeOf(terminal) != NodeType::Terminal)
      {
        continue;
      }
      const int before =
        atFront ? branch.Nodes[1] : branch.Nodes[branch.Nodes.size() - 2];
      SkeletonNode& node = skeleton.Graph[terminal];
      const Eigen::Vector3d direction = node.Position - skeleton.Graph[before].Position;
      int tip = -1;
      double farthest = 0.0;
      for (const int v : node.Vertices)
      {
        const double along = (mesh.Points[v] - node.Position).dot(direction);
        if (along > farthest)
        {
          farthest = along;
          tip = v;
        }
      }
      if (tip >= 0)
      {
        node.Position += TowardsTip * (mesh.Points[tip] - node.Position);
      }
    }
  }
  skeleton.UpdateArcLengths();
}
}
