// SPDX-License-Identifier: BSD-3-Clause
#include "CreatureSkeleton.h"

#include <algorithm>
#include <limits>

namespace marrow
{
namespace
{
constexpr int SamplesPerNode = 2;

int AddNode(CreatureSkeleton& skeleton, const CenterLine& line, int sample)
{
  SkeletonNode node;
  node.Position = line.Positions[sample];
  node.Radius = line.Radii[sample];
  return static_cast<int>(boost::add_vertex(node, skeleton.Graph.Graph));
}

/// The graph's path lengths between all pairs of nodes (Floyd and Warshall: a few hundred nodes).
std::vector<std::vector<double>> PathLengths(const SkeletonGraph& graph)
{
  const std::size_t size = boost::num_vertices(graph);
  std::vector<std::vector<double>> length(
    size, std::vector<double>(size, std::numeric_limits<double>::infinity()));
  for (auto [e, end] = boost::edges(graph); e != end; ++e)
  {
    const std::size_t a = boost::source(*e, graph);
    const std::size_t b = boost::target(*e, graph);
    length[a][b] = length[b][a] = (graph[a].Position - graph[b].Position).norm();
  }
  for (std::size_t k = 0; k < size; ++k)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      const double toK = length[i][k];
      for (std::size_t j = 0; j < size; ++j)
      {
        length[i][j] = std::min(length[i][j], toK + length[k][j]);
      }
    }
  }
  return length;
}
}

CreatureSkeleton MakeCreatureSkeleton(const Creature& creature, const ImplicitCreature& implicit)
{
  CreatureSkeleton skeleton;
  std::vector<std::vector<int>> nodeOfJoint;
  for (std::size_t i = 0; i < creature.Limbs.size(); ++i)
  {
    const Limb& limb = creature.Limbs[i];
    const CenterLine& line = implicit.CenterLines()[i];
    const int perJoint = limb.IsSlab() ? 1 : CenterLine::SamplesPerSpan;
    const int samples = static_cast<int>(line.Positions.size());
    std::vector<int> nodes;
    std::vector<int> ofJoint(limb.Joints.size());
    for (int s = 0; s < samples; s += limb.IsSlab() ? 1 : SamplesPerNode)
    {
      const bool first = s == 0;
      const bool last = s == samples - 1;
      int node = -1;
      if (first && limb.Parent >= 0)
      {
        node = nodeOfJoint[limb.Parent][limb.ParentJoint];
      }
      else if (last && limb.End >= 0)
      {
        node = nodeOfJoint[limb.End][limb.EndJoint];
      }
      else if (last && limb.Closed)
      {
        node = nodes.front();
      }
      else
      {
        node = AddNode(skeleton, line, s);
      }
      if (!first)
      {
        // A slab is a star about its middle.
        boost::add_edge(limb.IsSlab() ? nodes.front() : nodes.back(), node, skeleton.Graph.Graph);
      }
      nodes.push_back(node);
      if (s % perJoint == 0 && s / perJoint < static_cast<int>(ofJoint.size()))
      {
        ofJoint[s / perJoint] = node;
      }
    }
    skeleton.NodesOfLimbs.push_back(std::move(nodes));
    nodeOfJoint.push_back(std::move(ofJoint));
  }
  return skeleton;
}

bool HasClearance(
  const CreatureSkeleton& posed, const CreatureSkeleton& resting, const Creature& creature)
{
  const SkeletonGraph& graph = posed.Graph.Graph;
  const SkeletonGraph& rest = resting.Graph.Graph;
  const std::vector<std::vector<double>> pathLength = PathLengths(rest);
  double blend = 0.0;
  for (const Limb& limb : creature.Limbs)
  {
    blend = std::max(blend, limb.Blend);
  }
  for (std::size_t a = 0; a < pathLength.size(); ++a)
  {
    for (std::size_t b = a + 1; b < pathLength.size(); ++b)
    {
      const double radii = graph[a].Radius + graph[b].Radius;
      const double restGap = (rest[a].Position - rest[b].Position).norm() - radii;
      // At half the blend apart the smooth union of two limbs is about to weld them.
      const double weld = 0.5 * blend;
      if (pathLength[a][b] < 2.2 * radii || restGap < weld)
      {
        continue;
      }
      const double thinner = std::min(graph[a].Radius, graph[b].Radius);
      const double clear = std::min(weld + 0.3 * thinner, std::max(weld, restGap - 0.25 * thinner));
      const double gap = (graph[a].Position - graph[b].Position).norm() - radii;
      if (gap < clear)
      {
        return false;
      }
    }
  }
  return true;
}

Skeleton AssociateVertices(
  const CreatureSkeleton& dense, const ImplicitCreature& implicit, const TriangleMesh& mesh)
{
  SkeletonGraph graph = dense.Graph.Graph;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const std::vector<int>& nodes = dense.NodesOfLimbs[implicit.PlaceOf(mesh.Points[v]).Limb];
    const int nearest = *std::min_element(nodes.begin(), nodes.end(),
      [&](int a, int b)
      {
        return (graph[a].Position - mesh.Points[v]).squaredNorm() <
          (graph[b].Position - mesh.Points[v]).squaredNorm();
      });
    graph[nearest].Vertices.push_back(v);
  }

  std::vector<bool> kept(boost::num_vertices(graph), true);
  for (std::size_t n = 0; n < kept.size(); ++n)
  {
    SkeletonNode& node = graph[n];
    if (!node.Vertices.empty())
    {
      node.Radius = 0.0;
      for (int v : node.Vertices)
      {
        node.Radius += (mesh.Points[v] - node.Position).norm() / node.Vertices.size();
      }
    }
    else if (boost::out_degree(n, graph) == 2)
    {
      const auto [first, last] = boost::adjacent_vertices(n, graph);
      const std::size_t a = *first;
      const std::size_t b = *std::next(first);
      if (a != b && !boost::edge(a, b, graph).second)
      {
        boost::clear_vertex(n, graph);
        boost::add_edge(a, b, graph);
        kept[n] = false;
      }
    }
  }

  Skeleton result;
  std::vector<int> newNode(kept.size(), -1);
  for (std::size_t n = 0; n < kept.size(); ++n)
  {
    if (kept[n])
    {
      newNode[n] = static_cast<int>(boost::add_vertex(graph[n], result.Graph));
    }
  }
  for (auto [e, end] = boost::edges(graph); e != end; ++e)
  {
    boost::add_edge(
      newNode[boost::source(*e, graph)], newNode[boost::target(*e, graph)], result.Graph);
  }
  result.MeshDiagonal = mesh.BoundingBoxDiagonal();
  result.ExtractBranches();
  return result;
}
}
