// SPDX-License-Identifier: BSD-3-Clause
#include "PairSelection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace marrow
{
namespace
{
/// Branches beyond are too short to tell shapes apart.
constexpr std::size_t NumberOfBranches = 12;
/// As many as a small collection's pairs would be a third of: enough for a vote, and for the spreading
/// to reach all in two rounds.
constexpr std::size_t NumberOfNeighbors = SmallCollection / 3;
/// Of fewer there are not two left to learn from when one is held back.
constexpr std::size_t LeastSources = 3;
/// More take longer, and settle it no better.
constexpr std::size_t MostHeldOut = 8;

/// Prim's algorithm: pairs that join all shapes at the least sum of distances.
void AddSpanningTree(
  const std::vector<std::vector<double>>& sketches, const std::function<void(int, int)>& add)
{
  const int n = static_cast<int>(sketches.size());
  std::vector<double> distance(n, std::numeric_limits<double>::infinity());
  std::vector<int> nearest(n, -1);
  std::vector<bool> isReached(n, false);
  int last = 0;
  for (int step = 1; step < n; ++step)
  {
    isReached[last] = true;
    int next = -1;
    for (int s = 0; s < n; ++s)
    {
      if (isReached[s])
      {
        continue;
      }
      const double toLast = SketchDistance(sketches[last], sketches[s]);
      if (toLast < distance[s])
      {
        distance[s] = toLast;
        nearest[s] = last;
      }
      if (next < 0 || distance[s] < distance[next])
      {
        next = s;
      }
    }
    if (next < 0)
    {
      return;
    }
    add(nearest[next], next);
    last = next;
  }
}
}

std::vector<double> SketchOf(const Skeleton& skeleton)
{
  const double diagonal = std::max(skeleton.MeshDiagonal, 1e-300);
  std::vector<std::pair<double, double>> branches;
  int terminals = 0;
  for (int node = 0; node < skeleton.NumberOfNodes(); ++node)
  {
    terminals += skeleton.TypeOf(node) == NodeType::Terminal ? 1 : 0;
  }
  for (const Branch& branch : skeleton.Branches)
  {
    const bool isLimb = skeleton.TypeOf(branch.Front()) == NodeType::Terminal ||
      skeleton.TypeOf(branch.Back()) == NodeType::Terminal;
    if (isLimb)
    {
      double radius = 0.0;
      for (const int node : branch.Nodes)
      {
        radius += skeleton.Graph[node].Radius / static_cast<double>(branch.Nodes.size());
      }
      branches.emplace_back(branch.Length() / diagonal, radius / diagonal);
    }
  }
  std::sort(branches.rbegin(), branches.rend());
  branches.resize(NumberOfBranches);
  // A limb more or less weighs as much as a branch a quarter of the diagonal longer.
  constexpr double ofOneLimb = 0.25;
  std::vector<double> sketch{ ofOneLimb * terminals, ofOneLimb * skeleton.NumberOfLoops() };
  for (const auto& [length, radius] : branches)
  {
    sketch.push_back(length);
    sketch.push_back(radius);
  }
  return sketch;
}

double SketchDistance(const std::vector<double>& first, const std::vector<double>& second)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    sum += std::abs(first[i] - second[i]);
  }
  return sum;
}

std::vector<std::pair<int, int>> SelectPairs(const std::vector<std::vector<double>>& sketches,
  const std::vector<int>& meshOfShape, const std::vector<bool>& isSource,
  const std::vector<bool>& isTold)
{
  const int n = static_cast<int>(sketches.size());
  std::set<std::pair<int, int>> pairs;
  const auto add = [&](int a, int b)
  {
    if (meshOfShape[a] != meshOfShape[b] && (isTold[a] || isTold[b]))
    {
      pairs.insert({ std::min(a, b), std::max(a, b) });
    }
  };
  const std::set<int> meshes(meshOfShape.begin(), meshOfShape.end());
  if (meshes.size() <= static_cast<std::size_t>(SmallCollection))
  {
    for (int a = 0; a < n; ++a)
    {
      for (int b = a + 1; b < n; ++b)
      {
        add(a, b);
      }
    }
    return { pairs.begin(), pairs.end() };
  }
  for (int a = 0; a < n; ++a)
  {
    if (!isTold[a])
    {
      continue;
    }
    for (const bool ofSources : { false, true })
    {
      std::vector<std::pair<double, int>> others;
      for (int b = 0; b < n; ++b)
      {
        if (meshOfShape[a] != meshOfShape[b] && isSource[b] == ofSources)
        {
          others.emplace_back(SketchDistance(sketches[a], sketches[b]), b);
        }
      }
      std::sort(others.begin(), others.end());
      for (std::size_t i = 0; i < std::min(NumberOfNeighbors, others.size()); ++i)
      {
        add(a, others[i].second);
      }
    }
  }
  AddSpanningTree(sketches, add);
  return { pairs.begin(), pairs.end() };
}

std::vector<int> MeshesToHoldOut(
  const std::vector<int>& meshOfShape, const std::vector<bool>& isSource)
{
  std::vector<int> meshes; // in the order of the shapes, which is that of the contents
  for (std::size_t s = 0; s < meshOfShape.size(); ++s)
  {
    if (isSource[s] && std::count(meshes.begin(), meshes.end(), meshOfShape[s]) == 0)
    {
      meshes.push_back(meshOfShape[s]);
    }
  }
  if (meshes.size() < LeastSources)
  {
    return {};
  }
  const std::size_t size = std::min(meshes.size(), MostHeldOut);
  std::vector<int> chosen;
  for (std::size_t i = 0; i < size; ++i)
  {
    chosen.push_back(meshes[i * meshes.size() / size]);
  }
  return chosen;
}

std::vector<bool> ShapesToTell(const std::vector<int>& meshOfShape,
  const std::vector<bool>& isSource, const std::vector<int>& heldOutMeshes)
{
  std::vector<bool> isTold;
  for (std::size_t s = 0; s < meshOfShape.size(); ++s)
  {
    isTold.push_back(!isSource[s] ||
      std::find(heldOutMeshes.begin(), heldOutMeshes.end(), meshOfShape[s]) != heldOutMeshes.end());
  }
  return isTold;
}

PairChoice ChoosePairs(const std::vector<SketchedShape>& shapes, bool learns)
{
  std::vector<std::vector<double>> sketches;
  std::vector<int> meshOfShape;
  std::vector<bool> isSource;
  for (const SketchedShape& shape : shapes)
  {
    sketches.push_back(shape.Sketch);
    meshOfShape.push_back(shape.Mesh);
    isSource.push_back(shape.IsSource);
  }
  PairChoice choice;
  if (learns)
  {
    choice.HeldOutMeshes = MeshesToHoldOut(meshOfShape, isSource);
  }
  choice.Pairs = SelectPairs(
    sketches, meshOfShape, isSource, ShapesToTell(meshOfShape, isSource, choice.HeldOutMeshes));
  return choice;
}
}
