// SPDX-License-Identifier: BSD-3-Clause
#include "MinimumCut.h"

// GCC sees Boost's edge iterators, which hold an optional, as maybe uninitialized.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>

namespace marrow
{
namespace
{
using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;

struct ArcProperties
{
  double Capacity = 0.0;
  double Residual = 0.0;
  Traits::edge_descriptor Reverse;
};

struct NodeProperties
{
  boost::default_color_type Color = boost::gray_color;
  long Distance = 0;
  Traits::edge_descriptor Predecessor;
};

using Graph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, NodeProperties, ArcProperties>;

void AddArcs(Graph& graph, int a, int b, double forward, double backward)
{
  const auto there = boost::add_edge(a, b, graph).first;
  const auto back = boost::add_edge(b, a, graph).first;
  graph[there].Capacity = forward;
  graph[back].Capacity = backward;
  graph[there].Reverse = back;
  graph[back].Reverse = there;
}
}

MinimumCut::MinimumCut(int numberOfNodes)
  : FromSource(numberOfNodes, 0.0)
  , ToSink(numberOfNodes, 0.0)
{
}

void MinimumCut::AddTerminal(int node, double costOnSinkSide, double costOnSourceSide)
{
  this->FromSource[node] += costOnSinkSide;
  this->ToSink[node] += costOnSourceSide;
}

void MinimumCut::AddEdge(int a, int b, double forward, double backward)
{
  this->Edges.push_back({ a, b, forward, backward });
}

std::vector<bool> MinimumCut::Solve() const
{
  const int n = static_cast<int>(this->FromSource.size());
  const int source = n;
  const int sink = n + 1;
  Graph graph(n + 2);
  for (int i = 0; i < n; ++i)
  {
    // Only the difference matters for the cut.
    const double difference = this->FromSource[i] - this->ToSink[i];
    if (difference > 0.0)
    {
      AddArcs(graph, source, i, difference, 0.0);
    }
    else if (difference < 0.0)
    {
      AddArcs(graph, i, sink, -difference, 0.0);
    }
  }
  for (const Edge& edge : this->Edges)
  {
    AddArcs(graph, edge.A, edge.B, edge.Forward, edge.Backward);
  }
  boost::boykov_kolmogorov_max_flow(graph, boost::get(&ArcProperties::Capacity, graph),
    boost::get(&ArcProperties::Residual, graph), boost::get(&ArcProperties::Reverse, graph),
    boost::get(&NodeProperties::Predecessor, graph), boost::get(&NodeProperties::Color, graph),
    boost::get(&NodeProperties::Distance, graph), boost::get(boost::vertex_index, graph), source,
    sink);
  std::vector<bool> onSourceSide(n);
  for (int i = 0; i < n; ++i)
  {
    onSourceSide[i] = graph[i].Color == boost::black_color;
  }
  return onSourceSide;
}
}
