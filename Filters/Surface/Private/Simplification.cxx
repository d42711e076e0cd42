// SPDX-License-Identifier: BSD-3-Clause
#include "Simplification.h"

#include "EdgeOperations.h"
#include "Quadric.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace marrow
{
namespace
{
/// How much a step along the surface counts beside one off it, squared: enough that flat regions, where
/// the quadrics tell nothing, are thinned out evenly, and too little to change the order elsewhere.
constexpr double EvenWeight = 1.0e-3;
/// Least cosine between a triangle's normals before and after: it turns by less than 60 degrees.
constexpr double LeastTurn = 0.5;
/// Least shape of a triangle (1 equilateral, 0 a line) unless it was worse before: one of 20 degrees has
/// about 0.45.
constexpr double LeastShape = 0.25;
/// The share of the edges that a pass may take at most: the cheapest, so that their costs hold.
constexpr double PassShare = 0.25;

double Shape(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0.0 ? 2.0 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares : 0.0;
}

/// About the middle of its box: quadrics square the coordinates, and would lose the digits of a shape
/// far from the origin.
TriangleMesh Centered(TriangleMesh mesh)
{
  Eigen::Vector3d low = mesh.Points.front();
  Eigen::Vector3d high = low;
  for (const auto& point : mesh.Points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector3d middle = 0.5 * (low + high);
  for (auto& point : mesh.Points)
  {
    point -= middle;
  }
  return mesh;
}

struct Candidate
{
  double Cost;
  int HalfEdge;
  bool Backward;
};

/// What the collapse of an edge costs, the cheaper way, and the pass before which that was found.
struct EdgeCost
{
  double Cost;
  int Pass = -1;
  bool Backward;
};

class Simplifying
{
public:
  explicit Simplifying(const TriangleMesh& input)
    : Collapsing(Centered(input))
    , Quadrics(input.Points.size())
    , RingArea(input.VertexAreas())
    , Locked(input.Points.size(), 0)
    , Costs(3 * input.Triangles.size())
    , Present(input.Triangles.size())
  {
    std::iota(this->Present.begin(), this->Present.end(), 0);
    const TriangleMesh& mesh = this->Collapsing.Mesh();
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      const Eigen::Vector3d areaVector = mesh.AreaVector(t);
      const double doubleArea = areaVector.norm();
      if (doubleArea <= 0.0)
      {
        continue;
      }
      const Eigen::Vector3d normal = areaVector / doubleArea;
      const auto& c = mesh.Triangles[t];
      const Quadric plane(normal, mesh.Points[c[0]], doubleArea / 6.0);
      for (int k = 0; k < 3; ++k)
      {
        this->Quadrics[c[k]] += plane;
        if (mesh.Opposite[3 * t + k] < 0)
        {
          // A plane that stands on the border keeps it in place.
          const Eigen::Vector3d& from = mesh.Points[c[k]];
          const Eigen::Vector3d edge = mesh.Points[c[(k + 1) % 3]] - from;
          const Quadric wall(normal.cross(edge).normalized(), from, edge.squaredNorm());
          this->Quadrics[c[k]] += wall;
          this->Quadrics[c[(k + 1) % 3]] += wall;
        }
      }
    }
  }

  EdgeOperations Collapsing;

  /// One pass; returns how many edges collapsed. Never goes below `goal` triangles by more than one.
  int Pass(int goal, double share)
  {
    const TriangleMesh& mesh = this->Collapsing.Mesh();
    this->Present.erase(std::remove_if(this->Present.begin(), this->Present.end(),
                          [&](int t) { return this->Collapsing.IsRemoved(t); }),
      this->Present.end());
    this->Candidates.clear();
    for (const int t : this->Present)
    {
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (mesh.Opposite[h] < h)
        {
          this->AddCandidate(h);
        }
      }
    }
    const auto isBefore = [&](const Candidate& a, const Candidate& b)
    {
      if (a.Cost != b.Cost)
      {
        return a.Cost < b.Cost;
      }
      const Eigen::Vector3d& p = mesh.Points[this->Goes(a)];
      const Eigen::Vector3d& q = mesh.Points[this->Goes(b)];
      return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    const std::size_t most = static_cast<std::size_t>(std::ceil(share * this->Candidates.size()));
    if (most < this->Candidates.size())
    {
      std::nth_element(this->Candidates.begin(), this->Candidates.begin() + most,
        this->Candidates.end(), isBefore);
      this->Candidates.resize(most);
    }
    std::sort(this->Candidates.begin(), this->Candidates.end(), isBefore);

    ++this->PassNumber;
    int collapsed = 0;
    for (const Candidate& candidate : this->Candidates)
    {
      if (this->Collapsing.NumberOfTriangles() <= goal)
      {
        break;
      }
      collapsed += this->TryCollapse(candidate) ? 1 : 0;
    }
    return collapsed;
  }

private:
  int Goes(const Candidate& candidate) const
  {
    const TriangleMesh& mesh = this->Collapsing.Mesh();
    return candidate.Backward ? mesh.To(candidate.HalfEdge) : mesh.From(candidate.HalfEdge);
  }

  int Stays(const Candidate& candidate) const
  {
    const TriangleMesh& mesh = this->Collapsing.Mesh();
    return candidate.Backward ? mesh.From(candidate.HalfEdge) : mesh.To(candidate.HalfEdge);
  }

  void AddCandidate(int h)
  {
    const TriangleMesh& mesh = this->Collapsing.Mesh();
    const int from = mesh.From(h);
    const int to = mesh.To(h);
    EdgeCost& known = this->Costs[h];
    // A cost holds until one of the edge's ends has drawn another vertex into it.
    if (std::max(this->Locked[from], this->Locked[to]) > known.Pass)
    {
      const double length = (mesh.Points[to] - mesh.Points[from]).squaredNorm();
      Quadric sum = this->Quadrics[from];
      sum += this->Quadrics[to];
      const double forward = sum.At(mesh.Points[to]) + EvenWeight * length * this->RingArea[from];
      const double backward = sum.At(mesh.Points[from]) + EvenWeight * length * this->RingArea[to];
      known = { std::min(forward, backward), this->PassNumber, backward < forward };
    }
    this->Candidates.push_back({ known.Cost, h, known.Backward });
  }

  bool TryCollapse(const Candidate& candidate)
  {
    const int h = candidate.HalfEdge;
    if (this->Collapsing.IsRemoved(h / 3))
    {
      return false;
    }
    const int goes = this->Goes(candidate);
    const int stays = this->Stays(candidate);
    if (this->Locked[goes] == this->PassNumber || this->Locked[stays] == this->PassNumber ||
      !this->Collapsing.CanCollapse(h, candidate.Backward) || this->Spoils(goes, stays))
    {
      return false;
    }
    // The costs of its edges have changed: they wait for the next pass.
    this->Locked[stays] = this->PassNumber;
    this->Collapsing.Collapse(h, candidate.Backward);
    this->Quadrics[stays] += this->Quadrics[goes];
    this->RingArea[stays] += this->RingArea[goes];
    return true;
  }

  /// Whether a triangle would turn over, or become thinner than it may.
  bool Spoils(int goes, int stays) const
  {
    const TriangleMesh& mesh = this->Collapsing.Mesh();
    const Eigen::Vector3d& to = mesh.Points[stays];
    bool spoils = false;
    double worstBefore = 1.0;
    double worstAfter = 1.0;
    mesh.ForEachOutgoing(goes,
      [&](int h)
      {
        const Eigen::Vector3d& from = mesh.Points[goes];
        const Eigen::Vector3d& b = mesh.Points[mesh.To(h)];
        const Eigen::Vector3d& c = mesh.Points[mesh.From(TriangleMesh::Previous(h))];
        worstBefore = std::min(worstBefore, Shape(from, b, c));
        if (mesh.To(h) == stays || mesh.From(TriangleMesh::Previous(h)) == stays)
        {
          return;
        }
        const Eigen::Vector3d before = (b - from).cross(c - from);
        const Eigen::Vector3d after = (b - to).cross(c - to);
        spoils = spoils || before.dot(after) < LeastTurn * before.norm() * after.norm();
        worstAfter = std::min(worstAfter, Shape(to, b, c));
      });
    return spoils || worstAfter < std::min(LeastShape, worstBefore);
  }

  std::vector<Quadric> Quadrics;
  std::vector<double> RingArea;
  std::vector<int> Locked;     ///< per vertex: the last pass that drew another into it
  std::vector<EdgeCost> Costs; ///< per half-edge
  std::vector<int> Present;    ///< the triangles that are left, at the start of a pass
  std::vector<Candidate> Candidates;
  int PassNumber = 0;
};
}

bool SimplifyMesh(
  const TriangleMesh& mesh, int maximumTriangles, const Progress& progress, SimplifiedMesh& output)
{
  Simplifying simplifying(mesh);
  EdgeOperations& collapsing = simplifying.Collapsing;
  const double start = std::log(std::max(1, mesh.NumberOfTriangles()));
  const double end = std::log(std::max(1, maximumTriangles));
  double share = PassShare;
  while (collapsing.NumberOfTriangles() > maximumTriangles)
  {
    const double left = std::log(collapsing.NumberOfTriangles());
    if (!Report(progress, 0.9 * (start - left) / std::max(1.0e-9, start - end)))
    {
      return false;
    }
    if (simplifying.Pass(maximumTriangles, share) == 0)
    {
      if (share >= 1.0)
      {
        break;
      }
      share = 1.0; // none of the cheapest may collapse
    }
  }

  const TriangleMesh& collapsed = collapsing.Mesh();
  const int numberOfOld = mesh.NumberOfVertices();
  std::vector<int> newVertex(numberOfOld, -1);
  output.Mesh = {};
  output.OldVertex.clear();
  output.TriangleOfOld.assign(mesh.Triangles.size(), -1);
  for (int v = 0; v < numberOfOld; ++v)
  {
    if (collapsed.Outgoing[v] >= 0)
    {
      newVertex[v] = output.Mesh.NumberOfVertices();
      output.Mesh.Points.push_back(mesh.Points[v]);
      output.OldVertex.push_back(v);
    }
  }
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (!collapsing.IsRemoved(t))
    {
      output.TriangleOfOld[t] = output.Mesh.NumberOfTriangles();
      const auto& c = collapsed.Triangles[t];
      output.Mesh.Triangles.push_back({ newVertex[c[0]], newVertex[c[1]], newVertex[c[2]] });
    }
  }
  output.Mesh.BuildConnectivity();

  output.VertexOfOld.assign(numberOfOld, -1);
  for (int v = 0; v < numberOfOld; ++v)
  {
    if (mesh.Outgoing[v] >= 0)
    {
      output.VertexOfOld[v] = newVertex[collapsing.Survivor(v)];
    }
  }
  return Report(progress, 1.0);
}
}
