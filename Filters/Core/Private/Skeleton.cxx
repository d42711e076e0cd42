// SPDX-License-Identifier: BSD-3-Clause
#include "Skeleton.h"

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <utility>

namespace marrow
{
namespace
{
using EdgeDescriptor = boost::graph_traits<SkeletonGraph>::edge_descriptor;

/// The edges of a graph, numbered, with the incident ones of every node in ascending order of the
/// node at the other end: the walk must not depend on the order in which edges were inserted.
class EdgeTable
{
public:
  explicit EdgeTable(const SkeletonGraph& graph)
    : Incident(boost::num_vertices(graph))
  {
    for (auto [e, end] = boost::edges(graph); e != end; ++e)
    {
      const int a = static_cast<int>(boost::source(*e, graph));
      const int b = static_cast<int>(boost::target(*e, graph));
      const int id = static_cast<int>(this->Used.size());
      this->Used.push_back(false);
      this->Incident[a].push_back({ b, id });
      this->Incident[b].push_back({ a, id });
    }
    for (auto& incident : this->Incident)
    {
      std::sort(incident.begin(), incident.end());
    }
  }

  struct Step
  {
    int Node;
    int Edge;
    bool operator<(const Step& other) const
    {
      return Node != other.Node ? Node < other.Node : Edge < other.Edge;
    }
  };
  std::vector<std::vector<Step>> Incident;
  std::vector<bool> Used;
};

Branch Walk(const SkeletonGraph& graph, EdgeTable& table, int start, const EdgeTable::Step& first)
{
  Branch branch;
  branch.Nodes.push_back(start);
  branch.ArcLength.push_back(0.0);
  EdgeTable::Step step = first;
  for (;;)
  {
    table.Used[step.Edge] = true;
    const double length = (graph[step.Node].Position - graph[branch.Nodes.back()].Position).norm();
    branch.Nodes.push_back(step.Node);
    branch.ArcLength.push_back(branch.ArcLength.back() + length);
    const auto& incident = table.Incident[step.Node];
    if (incident.size() != 2 || step.Node == start)
    {
      return branch;
    }
    step = incident[0].Edge == step.Edge ? incident[1] : incident[0];
  }
}
}

NodeType Skeleton::TypeOf(int node) const
{
  return static_cast<NodeType>(std::min<std::size_t>(boost::out_degree(node, this->Graph), 3));
}

std::vector<std::vector<int>> Skeleton::BranchesOfNodes() const
{
  std::vector<std::vector<int>> result(boost::num_vertices(this->Graph));
  for (int b = 0; b < this->NumberOfBranches(); ++b)
  {
    result[this->Branches[b].Front()].push_back(b);
    result[this->Branches[b].Back()].push_back(b);
  }
  return result;
}

int Skeleton::NumberOfComponents() const
{
  std::vector<int> component(boost::num_vertices(this->Graph));
  return component.empty() ? 0 : boost::connected_components(this->Graph, component.data());
}

int Skeleton::NumberOfLoops() const
{
  return static_cast<int>(boost::num_edges(this->Graph)) -
    static_cast<int>(boost::num_vertices(this->Graph)) + this->NumberOfComponents();
}

double Skeleton::TotalLength() const
{
  double total = 0.0;
  for (const Branch& branch : this->Branches)
  {
    total += branch.Length();
  }
  return total;
}

void Skeleton::ExtractBranches()
{
  this->Branches.clear();
  EdgeTable table(this->Graph);
  const int numberOfNodes = this->NumberOfNodes();
  // First from every feature node; what is left then are cycles without one.
  for (const bool promoted : { false, true })
  {
    for (int node = 0; node < numberOfNodes; ++node)
    {
      if ((table.Incident[node].size() != 2) == promoted)
      {
        continue;
      }
      for (const auto& step : table.Incident[node])
      {
        if (!table.Used[step.Edge])
        {
          this->Branches.push_back(Walk(this->Graph, table, node, step));
        }
      }
    }
  }
}

void Skeleton::UpdateArcLengths()
{
  for (Branch& branch : this->Branches)
  {
    for (std::size_t i = 1; i < branch.Nodes.size(); ++i)
    {
      const Eigen::Vector3d& before = this->Graph[branch.Nodes[i - 1]].Position;
      branch.ArcLength[i] =
        branch.ArcLength[i - 1] + (this->Graph[branch.Nodes[i]].Position - before).norm();
    }
  }
}

void Append(Skeleton& skeleton, const Skeleton& other)
{
  const int first = skeleton.NumberOfNodes();
  for (int n = 0; n < other.NumberOfNodes(); ++n)
  {
    boost::add_vertex(other.Graph[n], skeleton.Graph);
  }
  for (auto [e, end] = boost::edges(other.Graph); e != end; ++e)
  {
    boost::add_edge(first + boost::source(*e, other.Graph), first + boost::target(*e, other.Graph),
      skeleton.Graph);
  }
  for (Branch branch : other.Branches)
  {
    for (int& node : branch.Nodes)
    {
      node += first;
    }
    skeleton.Branches.push_back(std::move(branch));
  }
  skeleton.MeshDiagonal = std::max(skeleton.MeshDiagonal, other.MeshDiagonal);
  skeleton.MeshMaximumMSP = std::max(skeleton.MeshMaximumMSP, other.MeshMaximumMSP);
}
}
