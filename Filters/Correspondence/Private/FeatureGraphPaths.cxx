// SPDX-License-Identifier: BSD-3-Clause
// What a FeatureGraph measures along paths of darts.
#include "FeatureGraph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace marrow
{
namespace
{
Eigen::Vector3d PointOf(
  const std::vector<Eigen::Vector3d>& positions, const Branch& path, double arc)
{
  const auto after = std::lower_bound(path.ArcLength.begin(), path.ArcLength.end(), arc);
  const std::size_t i =
    std::clamp<std::size_t>(after - path.ArcLength.begin(), 1, path.ArcLength.size() - 1);
  const double step = path.ArcLength[i] - path.ArcLength[i - 1];
  const double t = step > 0.0 ? std::clamp((arc - path.ArcLength[i - 1]) / step, 0.0, 1.0) : 0.0;
  return (1.0 - t) * positions[path.Nodes[i - 1]] + t * positions[path.Nodes[i]];
}
}

Branch FeatureGraph::Reversed(const Branch& branch)
{
  Branch result = branch;
  std::reverse(result.Nodes.begin(), result.Nodes.end());
  const double length = branch.Length();
  for (std::size_t i = 0; i < branch.ArcLength.size(); ++i)
  {
    result.ArcLength[i] = length - branch.ArcLength[branch.ArcLength.size() - 1 - i];
  }
  return result;
}

FeatureGraph::ShortestPaths FeatureGraph::ShortestPathsFrom(int feature, bool inForest) const
{
  using Arrival = std::pair<double, int>;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<Arrival>> open;
  ShortestPaths paths;
  paths.Length.assign(this->NumberOfFeatures(), std::numeric_limits<double>::infinity());
  paths.Arrival.assign(this->NumberOfFeatures(), -1);
  paths.Length[feature] = 0.0;
  open.emplace(0.0, feature);
  while (!open.empty())
  {
    const auto [length, at] = open.top();
    open.pop();
    if (length > paths.Length[at])
    {
      continue;
    }
    for (const int dart : this->Features[at].Darts)
    {
      const int head = this->Head(dart);
      const double next = length + this->Length(dart / 2);
      if ((!inForest || this->IsInForest(dart / 2)) && next < paths.Length[head])
      {
        paths.Length[head] = next;
        paths.Arrival[head] = dart;
        open.emplace(next, head);
      }
    }
  }
  return paths;
}

std::vector<double> FeatureGraph::DistancesFromNode(int node) const
{
  std::vector<double> distances(this->NumberOfFeatures(), std::numeric_limits<double>::infinity());
  for (int branch = 0; branch < this->NumberOfBranches(); ++branch)
  {
    const Branch& path = this->Branches[branch].Path;
    const auto found = std::find(path.Nodes.begin(), path.Nodes.end(), node);
    if (found == path.Nodes.end())
    {
      continue;
    }
    const double arc = path.ArcLength[found - path.Nodes.begin()];
    for (const auto& [dart, toEnd] :
      { std::pair{ 2 * branch, arc }, std::pair{ 2 * branch + 1, path.Length() - arc } })
    {
      const ShortestPaths paths = this->ShortestPathsFrom(this->Origin(dart), true);
      for (int f = 0; f < this->NumberOfFeatures(); ++f)
      {
        distances[f] = std::min(distances[f], toEnd / this->Total + paths.Length[f]);
      }
    }
  }
  return distances;
}

Eigen::Vector3d FeatureGraph::Direction(const FeatureGroup& group, int dart) const
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (int feature : group.Features)
  {
    center += this->Features[feature].Position;
  }
  center /= static_cast<double>(group.Features.size());
  double radius = 0.0;
  for (int feature : group.Features)
  {
    const Feature& f = this->Features[feature];
    radius = std::max(radius, f.Radius + (f.Position - center).norm());
  }
  const Branch path = this->Concatenate({ dart });
  // The branch leaves the ball on its first edge with an end outside; a branch that never does
  // counts as a whole.
  Eigen::Vector3d exit = this->Positions[path.Back()];
  for (std::size_t i = 1; i < path.Nodes.size(); ++i)
  {
    const Eigen::Vector3d& a = this->Positions[path.Nodes[i - 1]];
    const Eigen::Vector3d& b = this->Positions[path.Nodes[i]];
    if ((b - center).norm() > radius)
    {
      const double da = std::min((a - center).norm(), radius);
      const double db = (b - center).norm();
      exit = a + (b - a) * (db > da ? (radius - da) / (db - da) : 1.0);
      break;
    }
  }
  const Eigen::Vector3d direction = exit - center;
  const double norm = direction.norm();
  return norm > 0.0 ? Eigen::Vector3d(direction / norm) : Eigen::Vector3d::Zero();
}

Branch FeatureGraph::Concatenate(const std::vector<int>& darts) const
{
  Branch result;
  for (int dart : darts)
  {
    const Branch& path = this->Branches[dart / 2].Path;
    const Branch part = dart % 2 == 1 ? Reversed(path) : path;
    const double offset = result.Nodes.empty() ? 0.0 : result.Length();
    for (std::size_t i = result.Nodes.empty() ? 0 : 1; i < part.Nodes.size(); ++i)
    {
      result.Nodes.push_back(part.Nodes[i]);
      result.ArcLength.push_back(offset + part.ArcLength[i]);
    }
  }
  return result;
}

std::vector<double> FeatureGraph::Profile(
  const std::vector<int>& darts, Measure measure, int pieces) const
{
  const Branch path = this->Concatenate(darts);
  const double piece = path.Length() / pieces;
  std::vector<double> result(pieces, 0.0);
  if (!(piece > 0.0))
  {
    std::fill(result.begin(), result.end(), this->Value(path.Front(), measure));
    return result;
  }
  for (std::size_t i = 1; i < path.Nodes.size(); ++i)
  {
    const double begin = path.ArcLength[i - 1];
    const double end = path.ArcLength[i];
    const double a = this->Value(path.Nodes[i - 1], measure);
    const double b = this->Value(path.Nodes[i], measure);
    for (int k = std::max(0, static_cast<int>(begin / piece) - 1); k < pieces; ++k)
    {
      const double from = std::max(begin, k * piece);
      const double to = std::min(end, (k + 1) * piece);
      if (from >= end)
      {
        break;
      }
      if (to > from)
      {
        // The integral of a linear function is its middle value times the width.
        const double middle = (0.5 * (from + to) - begin) / (end - begin);
        result[k] += ((1.0 - middle) * a + middle * b) * (to - from) / piece;
      }
    }
  }
  return result;
}

Eigen::Vector3d FeatureGraph::PointAt(const std::vector<int>& darts, double fraction) const
{
  const Branch path = this->Concatenate(darts);
  return PointOf(this->Positions, path, fraction * path.Length());
}

double ProfileDistance(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return a.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(a.size()));
}
}
