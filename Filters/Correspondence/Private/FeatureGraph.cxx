// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGraph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace marrow
{
namespace
{
auto NodeKey(const SkeletonNode& node)
{
  const Eigen::Vector3d& p = node.Position;
  return std::make_tuple(node.AGD, node.MSP, node.Radius, p.x(), p.y(), p.z());
}
}

bool FeatureGroup::Contains(int feature) const
{
  return std::binary_search(this->Features.begin(), this->Features.end(), feature);
}

FeatureGraph::FeatureGraph(const Skeleton& skeleton, int pieces)
  : Bones(skeleton)
  , Diagonal(skeleton.MeshDiagonal)
{
  this->SmoothPositions();
  this->Branches.resize(skeleton.NumberOfBranches());
  for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
  {
    OrientedBranch& branch = this->Branches[b];
    branch.Source = b;
    branch.Path = skeleton.Branches[b];
    for (std::size_t i = 1; i < branch.Path.Nodes.size(); ++i)
    {
      branch.Path.ArcLength[i] = branch.Path.ArcLength[i - 1] +
        (this->Positions[branch.Path.Nodes[i]] - this->Positions[branch.Path.Nodes[i - 1]]).norm();
    }
    // The inner neighbours of the ends tell the two directions of a loop apart.
    const auto& nodes = branch.Path.Nodes;
    const auto key = [&](int end, int next)
    { return std::make_tuple(NodeKey(skeleton.Graph[end]), NodeKey(skeleton.Graph[next])); };
    branch.Flipped = key(nodes.back(), nodes[nodes.size() - 2]) < key(nodes.front(), nodes[1]);
    if (branch.Flipped)
    {
      branch.Path = Reversed(branch.Path);
    }
    this->Total += branch.Path.Length();
  }
  // All nodes in one place: nothing to measure, but nothing to divide by zero either.
  this->Total = this->Total > 0.0 ? this->Total : 1.0;
  std::sort(this->Branches.begin(), this->Branches.end(),
    [&](const OrientedBranch& a, const OrientedBranch& b)
    {
      const auto key = [&](const OrientedBranch& branch)
      {
        const auto& nodes = branch.Path.Nodes;
        return std::make_tuple(NodeKey(skeleton.Graph[nodes.front()]),
          NodeKey(skeleton.Graph[nodes.back()]), NodeKey(skeleton.Graph[nodes[1]]), branch.Source);
      };
      return key(a) < key(b);
    });
  this->AddFeatures();
  this->FindComponents();
  this->FindForest();
  this->Descriptors.resize(2 * this->Branches.size());
  for (int dart = 0; dart < 2 * this->NumberOfBranches(); ++dart)
  {
    this->Descriptors[dart] = this->Profile({ dart }, Measure::MSP, pieces);
  }
}

void FeatureGraph::SmoothPositions()
{
  /// Zigzag of one or two nodes is gone after so many, and bends of more stay.
  constexpr int sweeps = 10;
  const SkeletonGraph& graph = this->Bones.Graph;
  this->Positions.resize(boost::num_vertices(graph));
  for (std::size_t n = 0; n < this->Positions.size(); ++n)
  {
    this->Positions[n] = graph[n].Position;
  }
  for (const Branch& branch : this->Bones.Branches)
  {
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      Eigen::Vector3d before = this->Positions[branch.Front()];
      for (std::size_t i = 1; i + 1 < branch.Nodes.size(); ++i)
      {
        Eigen::Vector3d& here = this->Positions[branch.Nodes[i]];
        const Eigen::Vector3d old = here;
        here = 0.25 * before + 0.5 * old + 0.25 * this->Positions[branch.Nodes[i + 1]];
        before = old;
      }
    }
  }
}

void FeatureGraph::AddFeatures()
{
  std::map<decltype(std::make_tuple(NodeKey(SkeletonNode()), 0)), int> order;
  for (const OrientedBranch& branch : this->Branches)
  {
    for (int node : { branch.Path.Front(), branch.Path.Back() })
    {
      order[std::make_tuple(NodeKey(this->Bones.Graph[node]), node)] = node;
    }
  }
  std::map<int, int> featureOfNode;
  for (const auto& entry : order)
  {
    const SkeletonNode& node = this->Bones.Graph[entry.second];
    Feature feature;
    feature.Node = entry.second;
    feature.AGD = node.AGD;
    feature.MSP = this->Value(entry.second, Measure::MSP);
    feature.Position = node.Position;
    feature.Radius = node.Radius;
    featureOfNode[feature.Node] = this->NumberOfFeatures();
    this->Features.push_back(feature);
  }
  this->FeatureOfDart.resize(2 * this->Branches.size());
  for (int b = 0; b < this->NumberOfBranches(); ++b)
  {
    this->FeatureOfDart[2 * b] = featureOfNode[this->Branches[b].Path.Front()];
    this->FeatureOfDart[2 * b + 1] = featureOfNode[this->Branches[b].Path.Back()];
    this->Features[this->FeatureOfDart[2 * b]].Darts.push_back(2 * b);
    this->Features[this->FeatureOfDart[2 * b + 1]].Darts.push_back(2 * b + 1);
  }
}

void FeatureGraph::FindComponents()
{
  std::vector<std::pair<double, int>> lengths;
  for (int start = 0; start < this->NumberOfFeatures(); ++start)
  {
    if (this->Features[start].Component >= 0)
    {
      continue;
    }
    const int component = static_cast<int>(lengths.size());
    double length = 0.0;
    std::vector<int> open{ start };
    this->Features[start].Component = component;
    while (!open.empty())
    {
      const int feature = open.back();
      open.pop_back();
      for (int dart : this->Features[feature].Darts)
      {
        length += 0.5 * this->Length(dart / 2);
        Feature& head = this->Features[this->Head(dart)];
        if (head.Component < 0)
        {
          head.Component = component;
          open.push_back(this->Head(dart));
        }
      }
    }
    lengths.emplace_back(-length, component);
  }
  std::sort(lengths.begin(), lengths.end());
  std::vector<int> rank(lengths.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    rank[lengths[i].second] = static_cast<int>(i);
    this->ComponentLengths.push_back(-lengths[i].first);
  }
  for (Feature& feature : this->Features)
  {
    feature.Component = rank[feature.Component];
  }
}

void FeatureGraph::FindForest()
{
  std::vector<int> shortestFirst(this->Branches.size());
  std::iota(shortestFirst.begin(), shortestFirst.end(), 0);
  std::stable_sort(shortestFirst.begin(), shortestFirst.end(),
    [&](int a, int b) { return this->Length(a) < this->Length(b); });
  std::vector<int> tree(this->Features.size());
  std::iota(tree.begin(), tree.end(), 0);
  this->Forest.assign(this->Branches.size(), false);
  for (int branch : shortestFirst)
  {
    const int from = tree[this->Origin(2 * branch)];
    const int to = tree[this->Head(2 * branch)];
    if (from != to)
    {
      this->Forest[branch] = true;
      std::replace(tree.begin(), tree.end(), from, to);
    }
  }
}

double FeatureGraph::Value(int node, Measure measure) const
{
  const SkeletonNode& n = this->Bones.Graph[node];
  switch (measure)
  {
    case Measure::AGD:
      return n.AGD;
    case Measure::Radius:
      return this->Diagonal > 0.0 ? n.Radius / this->Diagonal : 0.0;
    default:
      return this->Bones.MeshMaximumMSP > 0.0 ? std::max(n.MSP, 0.0) / this->Bones.MeshMaximumMSP
                                              : 0.0;
  }
}

double FeatureGraph::Length(const std::vector<int>& darts) const
{
  return std::accumulate(darts.begin(), darts.end(), 0.0,
    [&](double sum, int dart) { return sum + this->Length(dart / 2); });
}

std::vector<int> FeatureGraph::OpenDarts(const FeatureGroup& group) const
{
  std::vector<int> result;
  for (int feature : group.Features)
  {
    for (int dart : this->Features[feature].Darts)
    {
      if (!std::binary_search(group.Inside.begin(), group.Inside.end(), dart / 2))
      {
        result.push_back(dart);
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<double> FeatureGraph::SubSkeletonSizes(
  const FeatureGroup& group, const std::vector<int>& openDarts) const
{
  // Part of every feature outside the group: what hangs together without it.
  std::vector<int> part(this->Features.size(), -1);
  std::vector<double> partLength;
  std::vector<int> partDarts;
  std::vector<int> partOfDart(openDarts.size(), -1);
  for (std::size_t i = 0; i < openDarts.size(); ++i)
  {
    const int first = this->Head(openDarts[i]);
    if (group.Contains(first))
    {
      continue;
    }
    if (part[first] < 0)
    {
      const int id = static_cast<int>(partLength.size());
      partLength.push_back(0.0);
      partDarts.push_back(0);
      part[first] = id;
      std::vector<int> open{ first };
      while (!open.empty())
      {
        const int feature = open.back();
        open.pop_back();
        for (int dart : this->Features[feature].Darts)
        {
          const int head = this->Head(dart);
          const bool toGroup = group.Contains(head);
          // A branch between two features of the part is met from both of them.
          partLength[id] += (toGroup ? 1.0 : 0.5) * this->Length(dart / 2);
          if (!toGroup && part[head] < 0)
          {
            part[head] = id;
            open.push_back(head);
          }
        }
      }
    }
    partOfDart[i] = part[first];
    ++partDarts[part[first]];
  }
  std::vector<double> sizes(openDarts.size());
  for (std::size_t i = 0; i < openDarts.size(); ++i)
  {
    const int p = partOfDart[i];
    sizes[i] = p < 0 ? 0.5 * this->Length(openDarts[i] / 2) : partLength[p] / partDarts[p];
  }
  return sizes;
}

double FeatureGraph::AGD(const FeatureGroup& group) const
{
  double sum = 0.0;
  for (int feature : group.Features)
  {
    sum += this->Features[feature].AGD;
  }
  return sum / static_cast<double>(group.Features.size());
}
}
