// SPDX-License-Identifier: BSD-3-Clause
#include "LoopOpening.h"

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
std::pair<int, int> EdgeKey(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}
}

OpenedSkeleton::OpenedSkeleton(const Skeleton& given)
  : Opened(given)
  , GivenNode(given.NumberOfNodes())
  , GivenBranches(given.NumberOfBranches())
{
  std::iota(this->GivenNode.begin(), this->GivenNode.end(), 0);
  for (int branch = 0; branch < given.NumberOfBranches(); ++branch)
  {
    this->Parts.push_back({ Part{ branch, false } });
  }
}

std::vector<OpenedSkeleton::Part> OpenedSkeleton::PartsAlong(int branch, bool against) const
{
  std::vector<Part> parts = this->Parts[branch];
  if (against)
  {
    std::reverse(parts.begin(), parts.end());
    for (Part& part : parts)
    {
      part.Reversed = !part.Reversed;
    }
  }
  return parts;
}

bool OpenedSkeleton::IsOnLoop(
  int branch, const std::vector<std::vector<int>>& branchesOfNodes) const
{
  // What is reached from the one end without the branch.
  const Branch& removed = this->Opened.Branches[branch];
  std::vector<bool> seen(this->Opened.NumberOfNodes(), false);
  std::vector<int> open{ removed.Front() };
  seen[removed.Front()] = true;
  while (!open.empty())
  {
    const int node = open.back();
    open.pop_back();
    for (int next : branchesOfNodes[node])
    {
      for (int end : { this->Opened.Branches[next].Front(), this->Opened.Branches[next].Back() })
      {
        if (next != branch && !seen[end])
        {
          seen[end] = true;
          open.push_back(end);
        }
      }
    }
  }
  return seen[removed.Back()];
}

std::vector<int> OpenedSkeleton::NodesToDrop(const BranchEnd& end) const
{
  std::vector<int> nodes = this->Opened.Branches[end.Branch].Nodes;
  if (end.AtBack)
  {
    std::reverse(nodes.begin(), nodes.end());
  }
  const SkeletonNode& junction = this->Opened.Graph[nodes.front()];
  const auto tip = std::find_if(nodes.begin() + 1, nodes.end(),
    [&](int node)
    { return (this->Opened.Graph[node].Position - junction.Position).norm() > junction.Radius; });
  // At least one edge stays.
  if (nodes.end() - tip < 2)
  {
    return {};
  }
  nodes.erase(tip + 1, nodes.end());
  return nodes;
}

std::vector<OpenedSkeleton::BranchEnd> OpenedSkeleton::OpenableEnds() const
{
  const std::vector<std::vector<int>> branchesOfNodes = this->Opened.BranchesOfNodes();
  std::vector<BranchEnd> result;
  for (int branch = 0; branch < this->Opened.NumberOfBranches(); ++branch)
  {
    if (!this->IsOnLoop(branch, branchesOfNodes))
    {
      continue;
    }
    for (const bool atBack : { false, true })
    {
      const Branch& path = this->Opened.Branches[branch];
      const BranchEnd end{ branch, atBack };
      const int junction = atBack ? path.Back() : path.Front();
      if (boost::out_degree(junction, this->Opened.Graph) == 3 && !this->NodesToDrop(end).empty())
      {
        result.push_back(end);
      }
    }
  }
  return result;
}

OpenedSkeleton OpenedSkeleton::OpenedAt(const BranchEnd& end) const
{
  const std::vector<int> dropped = this->NodesToDrop(end);
  OpenedSkeleton result = *this;
  for (std::size_t i = 1; i < dropped.size(); ++i)
  {
    boost::remove_edge(dropped[i - 1], dropped[i], result.Opened.Graph);
  }
  result.GivenNode[dropped.back()] = this->GivenNode[dropped.front()];
  result.Opened.ExtractBranches();

  // Which branch an edge was of, and which way round. Two branches may have the same only edge.
  std::multimap<std::pair<int, int>, std::pair<int, bool>> branchOfEdge;
  for (int branch = 0; branch < this->Opened.NumberOfBranches(); ++branch)
  {
    const std::vector<int>& nodes = this->Opened.Branches[branch].Nodes;
    for (std::size_t i = 1; i < nodes.size(); ++i)
    {
      branchOfEdge.emplace(
        EdgeKey(nodes[i - 1], nodes[i]), std::make_pair(branch, nodes[i - 1] < nodes[i]));
    }
  }
  result.Parts.clear();
  for (const Branch& path : result.Opened.Branches)
  {
    std::vector<Part> parts;
    int last = -1;
    for (std::size_t i = 1; i < path.Nodes.size(); ++i)
    {
      const auto found = branchOfEdge.find(EdgeKey(path.Nodes[i - 1], path.Nodes[i]));
      const auto [branch, ascends] = found->second;
      branchOfEdge.erase(found);
      if (branch == last)
      {
        continue;
      }
      last = branch;
      const bool against = ascends != (path.Nodes[i - 1] < path.Nodes[i]);
      const std::vector<Part> added = this->PartsAlong(branch, against);
      parts.insert(parts.end(), added.begin(), added.end());
    }
    result.Parts.push_back(parts);
  }
  return result;
}
}
