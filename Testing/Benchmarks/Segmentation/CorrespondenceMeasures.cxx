// SPDX-License-Identifier: BSD-3-Clause
#include "CorrespondenceMeasures.h"

#include <algorithm>
#include <map>
#include <set>

namespace marrow::bench
{
namespace
{
using Groups = std::map<int, std::vector<int>>;

Groups NodesOfIds(const MatchedSide& side)
{
  Groups groups;
  for (int node = 0; node < static_cast<int>(side.CorrespondenceOfNode.size()); ++node)
  {
    if (side.CorrespondenceOfNode[node] >= 0)
    {
      groups[side.CorrespondenceOfNode[node]].push_back(node);
    }
  }
  return groups;
}

bool AllTerminals(const MatchedSide& side, const std::vector<int>& nodes)
{
  return std::all_of(nodes.begin(), nodes.end(),
    [&](int node) { return side.Mesh.PlainSkeleton.TypeOf(node) == NodeType::Terminal; });
}

std::set<int> FeaturesOf(const MatchedSide& side, const std::vector<int>& nodes)
{
  std::set<int> features;
  for (const int node : nodes)
  {
    features.insert(side.Features.OfNode[node].begin(), side.Features.OfNode[node].end());
  }
  return features;
}

void CountFeatureNodes(const MatchedSide& side, Result& result)
{
  for (int node = 0; node < side.Mesh.PlainSkeleton.NumberOfNodes(); ++node)
  {
    const NodeType type = side.Mesh.PlainSkeleton.TypeOf(node);
    if (type == NodeType::Terminal || type == NodeType::Junction)
    {
      result.Values["feature_nodes"] += 1.0;
      result.Values["matched_feature_nodes"] += side.CorrespondenceOfNode[node] >= 0;
    }
  }
}
}

void MeasureCorrespondence(const MatchedSide& source, const MatchedSide& target,
  const std::vector<int>& mirrorFeatures, Result& result)
{
  for (const char* count :
    { "matched_pairs", "same_label_pairs", "matched_terminals", "same_label_terminals",
      "judged_pairs", "consistent_pairs", "left_right_flips", "front_back_flips" })
  {
    result.Values[count] = 0.0;
  }
  Groups targetGroups = NodesOfIds(target);
  for (const auto& [id, sourceNodes] : NodesOfIds(source))
  {
    const std::vector<int>& targetNodes = targetGroups[id];
    const bool sameLabel = MajorityOfNodes(source.Mesh, sourceNodes, source.Mesh.Labels) ==
      MajorityOfNodes(target.Mesh, targetNodes, target.Mesh.Labels);
    result.Values["matched_pairs"] += 1.0;
    result.Values["same_label_pairs"] += sameLabel;
    if (!AllTerminals(source, sourceNodes) || !AllTerminals(target, targetNodes))
    {
      continue;
    }
    result.Values["matched_terminals"] += 1.0;
    result.Values["same_label_terminals"] += sameLabel;

    const std::set<int> sourceFeatures = FeaturesOf(source, sourceNodes);
    const std::set<int> targetFeatures = FeaturesOf(target, targetNodes);
    if (sourceFeatures.empty() || targetFeatures.empty())
    {
      continue;
    }
    const auto targetHas = [&](int feature) { return targetFeatures.count(feature) > 0; };
    const auto targetHasMirror = [&](int feature)
    { return !mirrorFeatures.empty() && targetHas(mirrorFeatures[feature]); };
    result.Values["judged_pairs"] += 1.0;
    if (std::any_of(sourceFeatures.begin(), sourceFeatures.end(), targetHas))
    {
      result.Values["consistent_pairs"] += 1.0;
    }
    else if (std::any_of(sourceFeatures.begin(), sourceFeatures.end(), targetHasMirror))
    {
      result.Values["left_right_flips"] += 1.0;
    }
    else if (sameLabel)
    {
      result.Values["front_back_flips"] += 1.0;
    }
  }
  CountFeatureNodes(source, result);
  CountFeatureNodes(target, result);
}
}
