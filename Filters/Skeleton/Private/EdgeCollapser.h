// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_EdgeCollapser_h
#define marrow_EdgeCollapser_h

#include "CollapseComplex.h"
#include "Progress.h"
#include "TournamentTree.h"

#include <vector>

namespace marrow
{
/// Sum of the squared distances to lines: pᵀ A p - 2 gᵀ p + d.
struct LineQuadric
{
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d G = Eigen::Vector3d::Zero();
  double D = 0.0;

  void AddLine(const Eigen::Vector3d& point, const Eigen::Vector3d& direction)
  {
    const Eigen::Matrix3d projection =
      Eigen::Matrix3d::Identity() - direction * direction.transpose();
    const Eigen::Vector3d projected = projection * point;
    this->A += projection;
    this->G += projected;
    this->D += point.dot(projected);
  }
  void Add(const LineQuadric& other)
  {
    this->A += other.A;
    this->G += other.G;
    this->D += other.D;
  }
  double operator()(const Eigen::Vector3d& p) const
  {
    return p.dot(this->A * p) - 2.0 * this->G.dot(p) + this->D;
  }
};

/// The work of CollapseToGraph. Whoever watches its progress can see how far the complex has come.
class EdgeCollapser
{
public:
  EdgeCollapser(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& position,
    const std::vector<double>& msp);

  /// False if `progress` asked to stop.
  bool Run(const Progress& progress);

  const CollapseComplex& GetComplex() const { return this->Complex; }

private:
  double& CostOf(int from, int edge)
  {
    return this->Costs[2 * edge + (this->Complex.EdgeAt(edge).A == from ? 0 : 1)];
  }
  /// The sum of the lengths of a vertex's edges.
  double LengthOfSpokes(int vertex) const;
  /// What the collapse of `from`, whose edges are so long, onto a neighbour costs.
  void SetCost(int from, double lengthOfSpokes, const CollapseComplex::Spoke& spoke);
  /// Looks again for a vertex's cheapest collapse.
  void UpdateCheapest(int from);
  /// Collapses a vertex where that is cheapest, or never there again if it may not.
  void Try(int from);
  void Collapse(int from, int to, int edge);
  /// The longest loop that the collapse would close, over the perimeter of its part; 0 if every one
  /// bounds, infinite if no more may be closed.
  double LoopToPerimeter(int from, int to, int edge) const;
  /// Triangles are left and no loop is short enough: the shortest one is closed all the same.
  bool CloseShortestLoop();

  CollapseComplex Complex;
  const std::vector<Eigen::Vector3d>& Position;
  const std::vector<double>& MSP;
  std::vector<LineQuadric> Quadric;
  std::vector<double> Costs;      ///< per edge those of its collapse one way and the other
  std::vector<int> CheapestEdges; ///< per vertex
  TournamentTree Cheapest;        ///< per vertex the cost of its collapse along that edge
};
}

#endif
