// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MinimumCut_h
#define marrow_MinimumCut_h

#include <vector>

namespace marrow
{
/// A graph with a source and a sink whose minimum cut is found by the Boykov-Kolmogorov maximum flow
/// of Boost.Graph. Nodes are numbered from 0.
class MinimumCut
{
public:
  explicit MinimumCut(int numberOfNodes);

  /// Adds to what it costs to put the node on the sink's and on the source's side.
  void AddTerminal(int node, double costOnSinkSide, double costOnSourceSide);
  /// Adds an edge: what it costs when a is on the source's and b on the sink's side, and the other
  /// way round.
  void AddEdge(int a, int b, double forward, double backward);

  /// Per node whether it is on the source's side. Nodes that either side suits go to the sink's.
  std::vector<bool> Solve() const;

private:
  struct Edge
  {
    int A;
    int B;
    double Forward;
    double Backward;
  };
  std::vector<double> FromSource;
  std::vector<double> ToSink;
  std::vector<Edge> Edges;
};
}

#endif
