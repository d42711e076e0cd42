// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeCollapse.h"

#include "EdgeCollapser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
constexpr double SamplingWeight = 0.1;
/// A loop that may be closed is short against the perimeter of the part it goes around: on the shrunk
/// mesh a loop around a tube has nearly no length, one through a hole at least the hole's own.
constexpr double TubeLoop = 0.5;
/// The cost of what is not done.
constexpr double Never = std::numeric_limits<double>::infinity();
constexpr int StepsPerReport = 256;
}

EdgeCollapser::EdgeCollapser(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& position,
  const std::vector<double>& msp)
  : Complex(mesh)
  , Position(position)
  , MSP(msp)
  , Quadric(position.size())
  , Costs(2 * static_cast<std::size_t>(this->Complex.NumberOfEdges()), Never)
  , CheapestEdges(position.size(), -1)
  , Cheapest(std::vector<double>(position.size(), Never))
{
  for (int e = 0; e < this->Complex.NumberOfEdges(); ++e)
  {
    const auto& edge = this->Complex.EdgeAt(e);
    Eigen::Vector3d direction = position[edge.B] - position[edge.A];
    const double length = direction.norm();
    if (length > 0.0)
    {
      direction /= length;
      this->Quadric[edge.A].AddLine(position[edge.A], direction);
      this->Quadric[edge.B].AddLine(position[edge.B], direction);
    }
  }
}

bool EdgeCollapser::Run(const Progress& progress)
{
  for (int v = 0; v < this->Complex.NumberOfVertices(); ++v)
  {
    const double length = this->LengthOfSpokes(v);
    for (const auto& spoke : this->Complex.SpokesOf(v))
    {
      this->SetCost(v, length, spoke);
    }
    this->UpdateCheapest(v);
  }
  const int atStart = std::max(1, this->Complex.NumberOfTriangles());
  for (;;)
  {
    int steps = 0;
    while (this->Complex.NumberOfTriangles() > 0 &&
      this->Cheapest.ValueAt(this->Cheapest.Least()) < Never)
    {
      this->Try(this->Cheapest.Least());
      if (++steps % StepsPerReport == 0 &&
        !Report(progress, 1.0 - static_cast<double>(this->Complex.NumberOfTriangles()) / atStart))
      {
        return false;
      }
    }
    if (this->Complex.NumberOfTriangles() == 0 || !this->CloseShortestLoop())
    {
      return true;
    }
  }
}

double EdgeCollapser::LengthOfSpokes(int vertex) const
{
  double length = 0.0;
  for (const auto& spoke : this->Complex.SpokesOf(vertex))
  {
    length += (this->Position[vertex] - this->Position[spoke.Neighbor]).norm();
  }
  return length;
}

void EdgeCollapser::SetCost(int from, double lengthOfSpokes, const CollapseComplex::Spoke& spoke)
{
  double& cost = this->CostOf(from, spoke.Edge);
  if (this->Complex.EdgeAt(spoke.Edge).Apexes.empty())
  {
    cost = Never;
    return;
  }
  const Eigen::Vector3d& to = this->Position[spoke.Neighbor];
  const double shape = this->Quadric[from](to) + this->Quadric[spoke.Neighbor](to);
  const double sampling = (this->Position[from] - to).norm() * lengthOfSpokes;
  cost = shape + SamplingWeight * sampling;
}

void EdgeCollapser::UpdateCheapest(int from)
{
  double least = Never;
  int neighbor = -1;
  for (const auto& spoke : this->Complex.SpokesOf(from))
  {
    const double cost = this->CostOf(from, spoke.Edge);
    if (cost < least || (cost == least && cost < Never && spoke.Neighbor < neighbor))
    {
      least = cost;
      neighbor = spoke.Neighbor;
      this->CheapestEdges[from] = spoke.Edge;
    }
  }
  this->Cheapest.Change(from, least);
}

void EdgeCollapser::Try(int from)
{
  const int e = this->CheapestEdges[from];
  const auto& edge = this->Complex.EdgeAt(e);
  const int to = edge.A == from ? edge.B : edge.A;
  if (!edge.Apexes.empty() && this->LoopToPerimeter(from, to, e) <= TubeLoop)
  {
    this->Collapse(from, to, e);
  }
  else
  {
    this->CostOf(from, e) = Never;
    this->UpdateCheapest(from);
  }
}

void EdgeCollapser::Collapse(int from, int to, int edge)
{
  this->Complex.Collapse(from, to, edge);
  this->Quadric[to].Add(this->Quadric[from]);
  this->Cheapest.Change(from, Never);
  const double length = this->LengthOfSpokes(to);
  for (const auto& spoke : this->Complex.SpokesOf(to))
  {
    this->SetCost(to, length, spoke);
    this->SetCost(spoke.Neighbor, this->LengthOfSpokes(spoke.Neighbor), { to, spoke.Edge });
    this->UpdateCheapest(spoke.Neighbor);
  }
  this->UpdateCheapest(to);
}

double EdgeCollapser::LoopToPerimeter(int from, int to, int edge) const
{
  const std::vector<int> thirds = this->Complex.ThirdsOfOpenLoops(from, to, edge);
  if (this->Complex.NumberOfClosedLoops() + static_cast<int>(thirds.size()) > this->Complex.Genus())
  {
    return std::numeric_limits<double>::infinity();
  }
  double ratio = 0.0;
  for (const int third : thirds)
  {
    const double length = (this->Position[from] - this->Position[to]).norm() +
      (this->Position[to] - this->Position[third]).norm() +
      (this->Position[third] - this->Position[from]).norm();
    const double perimeter = std::min({ this->MSP[from], this->MSP[to], this->MSP[third] });
    ratio = std::max(ratio, perimeter > 0.0 ? length / perimeter : length);
  }
  return ratio;
}

bool EdgeCollapser::CloseShortestLoop()
{
  double best = std::numeric_limits<double>::infinity();
  int bestEdge = -1;
  for (int e = 0; e < this->Complex.NumberOfEdges(); ++e)
  {
    const auto& edge = this->Complex.EdgeAt(e);
    if (!edge.Alive || edge.Apexes.empty())
    {
      continue;
    }
    const double ratio = this->LoopToPerimeter(edge.A, edge.B, e);
    if (ratio < best)
    {
      best = ratio;
      bestEdge = e;
    }
  }
  if (bestEdge < 0)
  {
    return false;
  }
  this->Collapse(this->Complex.EdgeAt(bestEdge).A, this->Complex.EdgeAt(bestEdge).B, bestEdge);
  return true;
}

SkeletonGraph CollapseToGraph(const TriangleMesh& closedMesh,
  const std::vector<Eigen::Vector3d>& position, const std::vector<double>& msp,
  const Progress& progress)
{
  EdgeCollapser collapser(closedMesh, position, msp);
  if (!collapser.Run(progress))
  {
    return {};
  }

  const CollapseComplex& complex = collapser.GetComplex();
  std::vector<int> nodeOfVertex(position.size(), -1);
  SkeletonGraph graph;
  for (int v = 0; v < complex.NumberOfVertices(); ++v)
  {
    if (complex.IsAlive(v) && closedMesh.Outgoing[v] >= 0)
    {
      nodeOfVertex[v] = static_cast<int>(boost::add_vertex(graph));
      SkeletonNode& node = graph[nodeOfVertex[v]];
      node.Position = position[v];
      node.Vertices = complex.MergedInto(v);
      std::sort(node.Vertices.begin(), node.Vertices.end());
    }
  }
  for (const int e : complex.GraphEdges(position))
  {
    const auto& edge = complex.EdgeAt(e);
    boost::add_edge(nodeOfVertex[edge.A], nodeOfVertex[edge.B], graph);
  }
  return graph;
}
}
