// SPDX-License-Identifier: BSD-3-Clause
#include "SpurPruning.h"

#include "BranchProjection.h"
#include "Constants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
/// A limb stands out by more than its radius times this: less is a bump of the surface.
constexpr double LimbProminence = 1.25;
/// Lengths within this factor of each other are limbs of one size, among which the gap is looked for.
constexpr double Window = 1.6;

/// A terminal branch that ends at a junction.
struct Candidate
{
  int Branch = -1;
  int Junction = -1;
  double Significance = 0.0;
};

/// A node number on a branch, 0 or the last.
struct BranchEnd
{
  int Branch;
  int Step;
};

class Pruner
{
public:
  Pruner(Skeleton& skeleton, const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& shrunk,
    const std::vector<double>& msp, double finestArea)
    : Pruned(skeleton)
    , Mesh(mesh)
    , Shrunk(shrunk)
    , MSP(msp)
    , RemovedLimb(mesh.Points.size(), -1)
    , Area(mesh.VertexAreas())
    , FinestArea(finestArea * std::accumulate(this->Area.begin(), this->Area.end(), 0.0))
  {
  }

  /// Removes `count` spurs, or as many as are less significant than the top of the window; returns
  /// the significances in the order of removal, and that of the first that stays.
  std::vector<double> Remove(int count)
  {
    std::vector<double> removed;
    for (;;)
    {
      const Candidate candidate = this->LeastSignificant();
      if (candidate.Branch < 0)
      {
        return removed;
      }
      removed.push_back(candidate.Significance);
      if (static_cast<int>(removed.size()) > count ||
        (count == AsManyAsPossible && candidate.Significance > Window))
      {
        return removed;
      }
      this->MarkLimb(candidate);
      this->RemoveBranch(candidate);
    }
  }

  const std::vector<int>& GetRemovedLimb() const { return this->RemovedLimb; }

  /// Stands for no bound.
  static constexpr int AsManyAsPossible = 1 << 30;

private:
  Candidate LeastSignificant() const
  {
    const Skeleton& skeleton = this->Pruned;
    Candidate least;
    for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
    {
      const Branch& branch = skeleton.Branches[b];
      const bool frontIsTerminal = skeleton.TypeOf(branch.Front()) == NodeType::Terminal;
      const bool backIsTerminal = skeleton.TypeOf(branch.Back()) == NodeType::Terminal;
      if (frontIsTerminal == backIsTerminal)
      {
        continue;
      }
      const int junction = frontIsTerminal ? branch.Back() : branch.Front();
      const int terminal = frontIsTerminal ? branch.Front() : branch.Back();
      const double significance = this->Significance(branch, junction, terminal);
      if (least.Branch < 0 || significance < least.Significance)
      {
        least = { b, junction, significance };
      }
    }
    return least;
  }

  double Significance(const Branch& branch, int junction, int terminal) const
  {
    const SkeletonNode& root = this->Pruned.Graph[junction];
    const SkeletonNode& tip = this->Pruned.Graph[terminal];
    double body = 0.0;
    for (const int v : root.Vertices)
    {
      body += (this->Mesh.Points[v] - root.Position).norm();
    }
    body /= std::max<std::size_t>(1, root.Vertices.size());

    double beyond = 0.0;
    for (const int v : tip.Vertices)
    {
      beyond = std::max(beyond, (this->Mesh.Points[v] - tip.Position).norm());
    }

    double area = 0.0;
    double outsideArea = 0.0;
    double outsideRadius = 0.0;
    for (const int node : branch.Nodes)
    {
      if (node == junction)
      {
        continue;
      }
      for (const int v : this->Pruned.Graph[node].Vertices)
      {
        area += this->Area[v];
        if ((this->Mesh.Points[v] - root.Position).norm() > body)
        {
          outsideArea += this->Area[v];
          outsideRadius += this->Area[v] * this->MSP[v] / (2.0 * Pi);
        }
      }
    }
    if (outsideArea <= 0.0)
    {
      return 0.0;
    }
    const double thickness = outsideRadius / outsideArea;
    const double prominence = (branch.Length() + beyond - body) / thickness;
    return std::max(0.0, std::min(prominence / LimbProminence, area / this->FinestArea));
  }

  /// The spurs that were removed from a limb before go with it.
  void MarkLimb(const Candidate& candidate)
  {
    const SkeletonGraph& graph = this->Pruned.Graph;
    const std::vector<BranchEnd> ends = this->EndsAt(candidate.Junction);
    for (const int node : this->Pruned.Branches[candidate.Branch].Nodes)
    {
      for (const int v : graph[node].Vertices)
      {
        if (node != candidate.Junction ||
          (this->RemovedLimb[v] < 0 && this->IsNearestTo(candidate.Branch, v, ends)))
        {
          this->RemovedLimb[v] = this->NumberOfRemovals;
        }
      }
    }
    ++this->NumberOfRemovals;
  }

  std::vector<BranchEnd> EndsAt(int junction) const
  {
    std::vector<BranchEnd> ends;
    for (int b = 0; b < this->Pruned.NumberOfBranches(); ++b)
    {
      const Branch& branch = this->Pruned.Branches[b];
      if (branch.Front() == junction)
      {
        ends.push_back({ b, 0 });
      }
      if (branch.Back() == junction)
      {
        ends.push_back({ b, static_cast<int>(branch.Nodes.size()) - 1 });
      }
    }
    return ends;
  }

  /// Whether a vertex of the junction is nearer to the branch than to all others. What is nearest to
  /// the junction itself is as near to one as to the other.
  bool IsNearestTo(int branch, int vertex, const std::vector<BranchEnd>& ends) const
  {
    double own = std::numeric_limits<double>::infinity();
    double others = own;
    for (const BranchEnd& end : ends)
    {
      double& least = end.Branch == branch ? own : others;
      const BranchProjection projection = ProjectNear(
        this->Shrunk[vertex], this->Pruned, this->Pruned.Branches[end.Branch], end.Step);
      least = std::min(least, projection.SquaredDistance);
    }
    return own < others;
  }

  void RemoveBranch(const Candidate& candidate)
  {
    Skeleton& skeleton = this->Pruned;
    SkeletonGraph& graph = skeleton.Graph;
    std::vector<char> dead(boost::num_vertices(graph), 0);
    auto& kept = graph[candidate.Junction].Vertices;
    for (const int node : skeleton.Branches[candidate.Branch].Nodes)
    {
      if (node != candidate.Junction)
      {
        dead[node] = 1;
        kept.insert(kept.end(), graph[node].Vertices.begin(), graph[node].Vertices.end());
      }
    }
    std::sort(kept.begin(), kept.end());

    SkeletonGraph smaller;
    std::vector<int> newNode(dead.size(), -1);
    for (std::size_t node = 0; node < dead.size(); ++node)
    {
      if (!dead[node])
      {
        newNode[node] = static_cast<int>(boost::add_vertex(smaller));
        smaller[newNode[node]] = std::move(graph[node]);
      }
    }
    for (auto [e, end] = boost::edges(graph); e != end; ++e)
    {
      const int a = newNode[boost::source(*e, graph)];
      const int b = newNode[boost::target(*e, graph)];
      if (a >= 0 && b >= 0)
      {
        boost::add_edge(a, b, smaller);
      }
    }
    graph = smaller;
    skeleton.ExtractBranches();
  }

  Skeleton& Pruned;
  const TriangleMesh& Mesh;
  const std::vector<Eigen::Vector3d>& Shrunk;
  const std::vector<double>& MSP;
  std::vector<int> RemovedLimb;
  int NumberOfRemovals = 0;
  std::vector<double> Area;
  double FinestArea;
};

/// How many of the removals to make: up to the widest gap between the significances so far and the
/// next one, measured inside the window.
int WidestGap(const std::vector<double>& significances)
{
  double reached = 0.0;
  double widest = 0.0;
  int count = 0;
  for (std::size_t k = 0; k <= significances.size(); ++k)
  {
    const double next = k < significances.size() ? std::max(reached, significances[k]) : Window;
    const double low = std::clamp(reached, 1.0 / Window, Window);
    const double high = std::clamp(next, 1.0 / Window, Window);
    if (high / low > widest)
    {
      widest = high / low;
      count = static_cast<int>(k);
    }
    reached = next;
  }
  return count;
}
}

std::vector<int> PruneSpurs(Skeleton& skeleton, const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& shrunk, const std::vector<double>& msp, double finestArea)
{
  Skeleton trial = skeleton;
  Pruner trialPruner(trial, mesh, shrunk, msp, finestArea);
  const int count = WidestGap(trialPruner.Remove(Pruner::AsManyAsPossible));
  Pruner pruner(skeleton, mesh, shrunk, msp, finestArea);
  pruner.Remove(count);
  return pruner.GetRemovedLimb();
}
}
