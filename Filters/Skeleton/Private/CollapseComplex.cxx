// SPDX-License-Identifier: BSD-3-Clause
#include "CollapseComplex.h"

#include "MeshCheck.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>

namespace marrow
{
namespace
{
bool IsZero(const HomologyClass& value)
{
  return std::all_of(value.begin(), value.end(), [](std::uint64_t word) { return word == 0; });
}

void ExclusiveOr(HomologyClass& value, const HomologyClass& other)
{
  for (std::size_t i = 0; i < value.size(); ++i)
  {
    value[i] ^= other[i];
  }
}

/// The position of the lowest bit that is set, in a class that is not zero.
std::size_t LowestBit(const HomologyClass& value)
{
  std::size_t bit = 0;
  while ((value[bit / 64] >> (bit % 64) & 1) == 0)
  {
    ++bit;
  }
  return bit;
}

bool HasBit(const HomologyClass& value, std::size_t bit)
{
  return (value[bit / 64] >> (bit % 64) & 1) != 0;
}

template <typename Values>
bool Contains(const Values& values, int value)
{
  return std::find(values.begin(), values.end(), value) != values.end();
}

/// Removes one occurrence, not keeping the order; false if there is none.
template <typename Values>
bool Remove(Values& values, int value)
{
  const auto found = std::find(values.begin(), values.end(), value);
  if (found == values.end())
  {
    return false;
  }
  *found = values.back();
  values.pop_back();
  return true;
}

/// A spanning forest: along it every vertex gets the sum of the classes from its root (potentials
/// turn an edge's bits into the class of the loop that the edge closes), a parent and a distance.
struct Forest
{
  struct Link
  {
    int Neighbor;
    double Length;
    const HomologyClass* Class;
  };

  explicit Forest(int numberOfVertices)
    : Neighbors(numberOfVertices)
    , Potential(numberOfVertices)
    , Parent(numberOfVertices, -1)
    , Depth(numberOfVertices, -1)
    , Distance(numberOfVertices, 0.0)
  {
  }

  void Root()
  {
    for (std::size_t root = 0; root < this->Neighbors.size(); ++root)
    {
      if (this->Depth[root] >= 0 || this->Neighbors[root].empty())
      {
        continue;
      }
      this->Depth[root] = 0;
      this->Potential[root].assign(this->Neighbors[root].front().Class->size(), 0);
      std::vector<int> stack(1, static_cast<int>(root));
      while (!stack.empty())
      {
        const int v = stack.back();
        stack.pop_back();
        for (const Link& link : this->Neighbors[v])
        {
          if (this->Depth[link.Neighbor] < 0)
          {
            this->Parent[link.Neighbor] = v;
            this->Depth[link.Neighbor] = this->Depth[v] + 1;
            this->Distance[link.Neighbor] = this->Distance[v] + link.Length;
            this->Potential[link.Neighbor] = this->Potential[v];
            ExclusiveOr(this->Potential[link.Neighbor], *link.Class);
            stack.push_back(link.Neighbor);
          }
        }
      }
    }
  }

  double PathLength(int a, int b) const
  {
    const double ends = this->Distance[a] + this->Distance[b];
    while (a != b)
    {
      int& deeper = this->Depth[a] >= this->Depth[b] ? a : b;
      deeper = this->Parent[deeper];
    }
    return ends - 2.0 * this->Distance[a];
  }

  std::vector<std::vector<Link>> Neighbors;
  std::vector<HomologyClass> Potential;
  std::vector<int> Parent;
  std::vector<int> Depth;
  std::vector<double> Distance;
};
}

CollapseComplex::CollapseComplex(const TriangleMesh& closedMesh)
  : Spokes(closedMesh.Points.size())
  , Merged(closedMesh.Points.size())
  , Alive(closedMesh.Points.size(), 1)
  , TriangleCount(closedMesh.NumberOfTriangles())
  , GenusAtStart(CheckMesh(closedMesh).Genus())
{
  std::vector<HomologyClass> annotation;
  if (this->GenusAtStart > 0)
  {
    annotation = AnnotateHalfEdges(closedMesh);
  }
  this->Edges.reserve(closedMesh.Opposite.size() / 2);
  for (int h = 0; h < static_cast<int>(closedMesh.Opposite.size()); ++h)
  {
    const int opposite = closedMesh.Opposite[h];
    if (h > opposite)
    {
      continue;
    }
    const int a = closedMesh.From(h);
    const int b = closedMesh.To(h);
    const int edge = this->NumberOfEdges();
    this->Edges.push_back({ a, b, true,
      { closedMesh.From(TriangleMesh::Previous(h)),
        closedMesh.From(TriangleMesh::Previous(opposite)) },
      annotation.empty() ? HomologyClass() : annotation[h] });
    this->Spokes[a].push_back({ b, edge });
    this->Spokes[b].push_back({ a, edge });
  }
  for (int v = 0; v < this->NumberOfVertices(); ++v)
  {
    this->Merged[v].assign(1, v);
  }
}

int CollapseComplex::FindEdge(int a, int b) const
{
  const int shorter = this->Spokes[a].size() <= this->Spokes[b].size() ? a : b;
  const int other = shorter == a ? b : a;
  for (const Spoke& spoke : this->Spokes[shorter])
  {
    if (spoke.Neighbor == other)
    {
      return spoke.Edge;
    }
  }
  return -1;
}

std::vector<int> CollapseComplex::ThirdsOfOpenLoops(int a, int b, int edge) const
{
  std::vector<int> thirds;
  if (this->GenusAtStart == 0)
  {
    return thirds;
  }
  for (const Spoke& spoke : this->Spokes[a])
  {
    const int other = spoke.Neighbor == b ? -1 : this->FindEdge(b, spoke.Neighbor);
    if (other < 0)
    {
      continue;
    }
    HomologyClass loop = this->Edges[edge].Class;
    ExclusiveOr(loop, this->Edges[spoke.Edge].Class);
    ExclusiveOr(loop, this->Edges[other].Class);
    if (!IsZero(loop))
    {
      thirds.push_back(spoke.Neighbor);
    }
  }
  return thirds;
}

void CollapseComplex::Collapse(int from, int to, int edge)
{
  // Adding a coboundary changes no loop's class and makes the edge itself zero.
  const HomologyClass along = this->Edges[edge].Class;
  if (!IsZero(along))
  {
    for (const Spoke& spoke : this->Spokes[from])
    {
      ExclusiveOr(this->Edges[spoke.Edge].Class, along);
    }
  }

  this->TriangleCount -= static_cast<int>(this->Edges[edge].Apexes.size());
  this->MoveTriangles(from, to);

  for (const Spoke& spoke : this->Spokes[from])
  {
    const int k = spoke.Neighbor;
    if (k == to)
    {
      continue;
    }
    Edge& moved = this->Edges[spoke.Edge];
    const int existing = this->FindEdge(to, k);
    if (existing < 0)
    {
      moved.A = to;
      moved.B = k;
      this->Spokes[to].push_back({ k, spoke.Edge });
      for (Spoke& back : this->Spokes[k])
      {
        if (back.Neighbor == from)
        {
          back.Neighbor = to;
        }
      }
      continue;
    }
    Edge& kept = this->Edges[existing];
    HomologyClass loop = kept.Class;
    ExclusiveOr(loop, moved.Class);
    for (const int apex : moved.Apexes)
    {
      if (apex != to && !Contains(kept.Apexes, apex))
      {
        kept.Apexes.push_back(apex);
      }
    }
    Remove(kept.Apexes, from);
    moved.Alive = false;
    moved.Apexes.clear();
    this->RemoveSpoke(k, from);
    if (!IsZero(loop))
    {
      this->CloseLoop(loop);
    }
  }
  this->RemoveSpoke(to, from);
  this->Edges[edge].Alive = false;
  this->Edges[edge].Apexes.clear();
  this->Spokes[from].clear();
  this->Alive[from] = 0;
  this->Merged[to].insert(
    this->Merged[to].end(), this->Merged[from].begin(), this->Merged[from].end());
  std::vector<int>().swap(this->Merged[from]);
}

void CollapseComplex::MoveTriangles(int from, int to)
{
  for (const Spoke& spoke : this->Spokes[from])
  {
    const int k = spoke.Neighbor;
    for (const int l : this->Edges[spoke.Edge].Apexes)
    {
      // Each triangle once, and not those that vanish with the edge.
      if (k >= l || k == to || l == to)
      {
        continue;
      }
      Edge& opposite = this->Edges[this->FindEdge(k, l)];
      Remove(opposite.Apexes, from);
      if (Contains(opposite.Apexes, to))
      {
        --this->TriangleCount; // two sheets fall together
      }
      else
      {
        opposite.Apexes.push_back(to);
      }
    }
  }
}

void CollapseComplex::CloseLoop(const HomologyClass& loop)
{
  // The classes that are left are those that vanish on the loop: one bit is folded into the others.
  const std::size_t pivot = LowestBit(loop);
  for (Edge& edge : this->Edges)
  {
    if (edge.Alive && HasBit(edge.Class, pivot))
    {
      ExclusiveOr(edge.Class, loop);
    }
  }
  ++this->ClosedLoops;
}

void CollapseComplex::RemoveSpoke(int vertex, int neighbor)
{
  auto& spokes = this->Spokes[vertex];
  const auto found = std::find_if(spokes.begin(), spokes.end(),
    [neighbor](const Spoke& spoke) { return spoke.Neighbor == neighbor; });
  *found = spokes.back();
  spokes.pop_back();
}

std::vector<int> CollapseComplex::GraphEdges(const std::vector<Eigen::Vector3d>& position) const
{
  struct Candidate
  {
    double Length;
    int Edge;
    bool operator<(const Candidate& other) const
    {
      return Length != other.Length ? Length < other.Length : Edge < other.Edge;
    }
  };
  std::vector<Candidate> alive;
  for (int e = 0; e < this->NumberOfEdges(); ++e)
  {
    if (this->Edges[e].Alive)
    {
      alive.push_back({ (position[this->Edges[e].A] - position[this->Edges[e].B]).norm(), e });
    }
  }
  std::vector<int> kept;
  if (this->TriangleCount == 0 && this->ClosedLoops == this->GenusAtStart)
  {
    for (const Candidate& candidate : alive)
    {
      kept.push_back(candidate.Edge);
    }
    return kept;
  }

  std::sort(alive.begin(), alive.end());
  std::vector<int> rank(this->Spokes.size(), 0);
  std::vector<int> parent(this->Spokes.size());
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  for (int v = 0; v < this->NumberOfVertices(); ++v)
  {
    sets.make_set(v);
  }
  Forest forest(this->NumberOfVertices());
  std::vector<Candidate> others;
  for (const Candidate& candidate : alive)
  {
    const Edge& edge = this->Edges[candidate.Edge];
    if (sets.find_set(edge.A) == sets.find_set(edge.B))
    {
      others.push_back(candidate);
      continue;
    }
    sets.union_set(edge.A, edge.B);
    kept.push_back(candidate.Edge);
    forest.Neighbors[edge.A].push_back({ edge.B, candidate.Length, &edge.Class });
    forest.Neighbors[edge.B].push_back({ edge.A, candidate.Length, &edge.Class });
  }
  forest.Root();

  for (Candidate& candidate : others)
  {
    candidate.Length +=
      forest.PathLength(this->Edges[candidate.Edge].A, this->Edges[candidate.Edge].B);
  }
  std::sort(others.rbegin(), others.rend());
  // Gauss elimination: an edge is kept if the class of its loop is independent of those before.
  std::vector<HomologyClass> basis;
  for (const Candidate& candidate : others)
  {
    const Edge& edge = this->Edges[candidate.Edge];
    HomologyClass loop = edge.Class;
    ExclusiveOr(loop, forest.Potential[edge.A]);
    ExclusiveOr(loop, forest.Potential[edge.B]);
    for (const HomologyClass& element : basis)
    {
      if (HasBit(loop, LowestBit(element)))
      {
        ExclusiveOr(loop, element);
      }
    }
    if (!IsZero(loop) && static_cast<int>(basis.size()) < this->GenusAtStart)
    {
      basis.push_back(loop);
      kept.push_back(candidate.Edge);
    }
  }
  return kept;
}
}
