// SPDX-License-Identifier: BSD-3-Clause
#include "BranchResampling.h"

#include "BranchProjection.h"
#include "Constants.h"
#include "PatchConnectivity.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace marrow
{
namespace
{
/// The terminal's place between the middle of its cap and the tip: inside, and close to the end.
constexpr double TowardsTip = 0.7;
/// The part of the cap, from its outermost point, that counts as the tip.
constexpr double EndOfCap = 0.8;
/// A node without φ still holds its place by this share of the mean, so that the system is definite.
constexpr double LeastHold = 1e-3;
constexpr double FixedHold = 1e3;
constexpr double LargestStiffness = 1e3;
/// How far a node's place reaches along the branch, over the local radius: no centre line winds more
/// tightly than the part is thick.
constexpr double SmoothingLength = 0.4;

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
      const int steps = std::max(least, static_cast<int>(std::lround(branch.Length() / spacing)));
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
    const int step = length > 0.0 ? static_cast<int>(std::lround(arc / length * steps)) : 0;
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

void JoinRemovedLimbs(const std::vector<int>& removedLimb, std::vector<int>& nodeOfVertex)
{
  std::map<int, std::map<int, int>> votesOfLimb;
  for (std::size_t v = 0; v < removedLimb.size(); ++v)
  {
    if (removedLimb[v] >= 0 && nodeOfVertex[v] >= 0)
    {
      ++votesOfLimb[removedLimb[v]][nodeOfVertex[v]];
    }
  }
  std::map<int, int> nodeOfLimb;
  for (const auto& [limb, votes] : votesOfLimb)
  {
    nodeOfLimb[limb] = std::max_element(votes.begin(), votes.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  }
  for (std::size_t v = 0; v < removedLimb.size(); ++v)
  {
    if (removedLimb[v] >= 0 && nodeOfVertex[v] >= 0)
    {
      nodeOfVertex[v] = nodeOfLimb[removedLimb[v]];
    }
  }
}
}

Skeleton ResampleBranches(const Skeleton& skeleton, const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& shrunk, const std::vector<double>& weight,
  const std::vector<int>& removedLimb, double spacing)
{
  Resampling resampling(skeleton, spacing);

  std::vector<int> nodeOfVertex(mesh.Points.size(), -1);
  std::vector<double> squaredDistance(mesh.Points.size(), std::numeric_limits<double>::infinity());
  for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
  {
    const Branch& branch = skeleton.Branches[b];
    const int numberOfNodes = static_cast<int>(branch.Nodes.size());
    for (int i = 0; i < numberOfNodes; ++i)
    {
      for (const int v : skeleton.Graph[branch.Nodes[i]].Vertices)
      {
        // The φ of a junction is seen once from each of its branches: the nearest takes the vertex.
        const BranchProjection projection = ProjectNear(shrunk[v], skeleton, branch, i);
        if (projection.SquaredDistance < squaredDistance[v])
        {
          squaredDistance[v] = projection.SquaredDistance;
          nodeOfVertex[v] = resampling.NodeAt(b, projection.Arc);
        }
      }
    }
  }
  JoinRemovedLimbs(removedLimb, nodeOfVertex);
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

void CenterNodes(
  Skeleton& skeleton, const std::vector<Eigen::Vector3d>& shrunk, const std::vector<double>& weight)
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

void SmoothBranches(
  Skeleton& skeleton, const std::vector<double>& weight, const std::vector<double>& msp)
{
  const double spacing =
    skeleton.TotalLength() / std::max<std::size_t>(1, boost::num_edges(skeleton.Graph));
  // Springs along the edges against springs to the present places; a node whose φ is small or poor
  // holds its place weakly and follows its neighbours.
  const int numberOfNodes = skeleton.NumberOfNodes();
  std::vector<double> hold(numberOfNodes, 0.0);
  std::vector<double> radius(numberOfNodes, 0.0);
  double total = 0.0;
  for (int n = 0; n < numberOfNodes; ++n)
  {
    double perimeter = 0.0;
    for (const int v : skeleton.Graph[n].Vertices)
    {
      hold[n] += weight[v];
      perimeter += weight[v] * msp[v];
    }
    radius[n] = hold[n] > 0.0 ? perimeter / hold[n] / (2.0 * Pi) : 0.0;
    total += hold[n];
  }
  if (!(total > 0.0) || !(spacing > 0.0))
  {
    // Nothing holds a place, or there is but one: the springs have no solution.
    return;
  }
  const double least = LeastHold * total / numberOfNodes;

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d right(numberOfNodes, 3);
  std::vector<double> diagonal(numberOfNodes);
  for (int n = 0; n < numberOfNodes; ++n)
  {
    // A terminal has a neighbour on one side only, and springs would shorten the limb.
    const bool isFree = skeleton.TypeOf(n) != NodeType::Terminal;
    diagonal[n] = isFree ? std::max(hold[n], least) : FixedHold * total;
    right.row(n) = diagonal[n] * skeleton.Graph[n].Position.transpose();
  }
  const double meanHold = std::max(total / numberOfNodes, least);
  for (auto [e, end] = boost::edges(skeleton.Graph); e != end; ++e)
  {
    const int a = static_cast<int>(boost::source(*e, skeleton.Graph));
    const int b = static_cast<int>(boost::target(*e, skeleton.Graph));
    const double reach = SmoothingLength * std::max(radius[a], radius[b]) / spacing;
    const double stiffness = meanHold * std::min(reach * reach, LargestStiffness);
    diagonal[a] += stiffness;
    diagonal[b] += stiffness;
    entries.emplace_back(a, b, -stiffness);
    entries.emplace_back(b, a, -stiffness);
  }
  for (int n = 0; n < numberOfNodes; ++n)
  {
    entries.emplace_back(n, n, diagonal[n]);
  }
  Eigen::SparseMatrix<double> matrix(numberOfNodes, numberOfNodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixX3d solution = solver.solve(right);
  for (int n = 0; n < numberOfNodes; ++n)
  {
    skeleton.Graph[n].Position = solution.row(n).transpose();
  }
}

void ExtendTerminals(
  Skeleton& skeleton, const TriangleMesh& mesh, const std::vector<int>& removedLimb)
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
      const int before = atFront ? branch.Nodes[1] : branch.Nodes[branch.Nodes.size() - 2];
      SkeletonNode& node = skeleton.Graph[terminal];
      const Eigen::Vector3d direction = node.Position - skeleton.Graph[before].Position;
      // The middle of the farthest end of the cap: a flat end has no corner to run to.
      double farthest = 0.0;
      for (const int v : node.Vertices)
      {
        if (removedLimb[v] < 0)
        {
          farthest = std::max(farthest, (mesh.Points[v] - node.Position).dot(direction));
        }
      }
      Eigen::Vector3d end = Eigen::Vector3d::Zero();
      int count = 0;
      for (const int v : node.Vertices)
      {
        if (removedLimb[v] < 0 &&
          (mesh.Points[v] - node.Position).dot(direction) >= EndOfCap * farthest)
        {
          end += mesh.Points[v];
          ++count;
        }
      }
      if (farthest > 0.0)
      {
        node.Position += TowardsTip * (end / count - node.Position);
      }
    }
  }
  skeleton.UpdateArcLengths();
}
}
