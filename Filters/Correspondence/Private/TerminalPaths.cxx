// SPDX-License-Identifier: BSD-3-Clause
#include "TerminalPaths.h"

#include "Constants.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace marrow
{
namespace
{
/// Finer ones would compare noise; the length of a joint is about one.
constexpr int ProfilePieces = 12;
/// The middle parts of a path whose straightness is compared: the tips move with the pose.
constexpr double ChordEnds[] = { 0.2, 0.35 };
/// Two terminals that differ by this are no twins.
constexpr double TwinTolerance = 0.25;
/// Where on a terminal's branch points are taken, from the tip on; the second one sees how a foot
/// stands on its leg.
constexpr double SampleFractions[] = { 0.0, 0.15, 0.5, 1.0 };

/// How far from the tip MSP is compared, over the mean length of the paths: closer where limbs differ most.
constexpr double TaperDistances[] = { 0.03, 0.06, 0.1, 0.15, 0.2, 0.3, 0.4 };
/// Fine enough for the distances above.
constexpr int TaperPieces = 64;

/// Between the inner halves of two terminal branches: the outer halves move with the pose.
double AngleBetween(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b)
{
  const Eigen::Vector3d u = (a[2] - a[3]).normalized();
  const Eigen::Vector3d v = (b[2] - b[3]).normalized();
  return std::acos(std::clamp(u.dot(v), -1.0, 1.0)) / Pi;
}
}

TerminalPaths::TerminalPaths(const FeatureGraph& graph)
  : Skeleton(graph)
{
  this->ChooseTerminals();
  this->FindPaths();
  this->FindSplits();
}

void TerminalPaths::ChooseTerminals()
{
  const FeatureGraph& graph = this->Skeleton;
  const auto surface = [&](int branch)
  {
    const auto& pieces = graph.Descriptor(2 * branch);
    return graph.Length(branch) * std::accumulate(pieces.begin(), pieces.end(), 0.0) /
      static_cast<double>(pieces.size());
  };
  std::vector<std::pair<double, int>> all;
  double lengths = 0.0;
  double surfaces = 0.0;
  for (int f = 0; f < graph.NumberOfFeatures(); ++f)
  {
    if (graph.GetFeatures()[f].IsTerminal())
    {
      const int branch = graph.GetFeatures()[f].Darts.front() / 2;
      lengths += graph.Length(branch);
      surfaces += surface(branch);
      all.emplace_back(0.0, f);
    }
  }
  for (auto& [weight, f] : all)
  {
    const int branch = graph.GetFeatures()[f].Darts.front() / 2;
    weight = 0.5 * (lengths > 0.0 ? graph.Length(branch) / lengths : 1.0 / all.size()) +
      0.5 * (surfaces > 0.0 ? surface(branch) / surfaces : 1.0 / all.size());
  }
  if (static_cast<int>(all.size()) > MaximumTerminals)
  {
    std::stable_sort(all.begin(), all.end(), std::greater<std::pair<double, int>>());
    all.resize(MaximumTerminals);
    std::sort(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  }
  this->TerminalOfFeature.assign(graph.NumberOfFeatures(), -1);
  const double sum = std::accumulate(all.begin(), all.end(), 0.0,
    [](double s, const std::pair<double, int>& entry) { return s + entry.first; });
  for (const auto& [weight, f] : all)
  {
    this->TerminalOfFeature[f] = this->Size();
    this->Features.push_back(f);
    this->Weights.push_back(weight / sum);
    const std::vector<int> branch{ graph.GetFeatures()[f].Darts.front() };
    std::vector<Eigen::Vector3d> points;
    for (double fraction : SampleFractions)
    {
      points.push_back(graph.PointAt(branch, fraction));
    }
    this->Samples.push_back(points);
  }
}

void TerminalPaths::FindPaths()
{
  const FeatureGraph& graph = this->Skeleton;
  this->Paths.resize(this->Size() * this->Size());
  double weightedLength = 0.0;
  double weights = 0.0;
  for (int from = 0; from < this->Size(); ++from)
  {
    const FeatureGraph::ShortestPaths shortest =
      graph.ShortestPathsFrom(this->Features[from], true);
    for (int to = 0; to < this->Size(); ++to)
    {
      Path& path = this->Paths[from * this->Size() + to];
      if (to == from || std::isinf(shortest.Length[this->Features[to]]))
      {
        continue;
      }
      path.Exists = true;
      path.Length = shortest.Length[this->Features[to]];
      for (int f = this->Features[to]; f != this->Features[from];
           f = graph.Origin(shortest.Arrival[f]))
      {
        path.Darts.push_back(shortest.Arrival[f]);
      }
      std::reverse(path.Darts.begin(), path.Darts.end());
      path.Angle = AngleBetween(this->Samples[from], this->Samples[to]);
      path.Profile = graph.Profile(path.Darts, FeatureGraph::Measure::MSP, ProfilePieces);
      // The root: a leg and an ear differ by as much as a leg and a body.
      for (double& value : path.Profile)
      {
        value = std::sqrt(value);
      }
      for (double end : ChordEnds)
      {
        const double chord =
          (graph.PointAt(path.Darts, end) - graph.PointAt(path.Darts, 1.0 - end)).norm();
        const double arc = (1.0 - 2.0 * end) * path.Length * graph.TotalLength();
        path.Chords.push_back(arc > 0.0 ? chord / arc : 1.0);
      }
      const double weight = this->Weights[from] * this->Weights[to];
      weightedLength += weight * path.Length;
      weights += weight;
    }
  }
  this->FindTapers(weights > 0.0 ? weightedLength / weights : 1.0);
  for (Path& path : this->Paths)
  {
    path.Length *= weightedLength > 0.0 ? weights / weightedLength : 1.0;
  }
  this->FindTwins();
}

void TerminalPaths::FindTwins()
{
  const auto& features = this->Skeleton.GetFeatures();
  for (int i = 0; i < this->Size(); ++i)
  {
    for (int k = 0; k < this->Size(); ++k)
    {
      Path& path = this->Paths[i * this->Size() + k];
      if (!path.Exists)
      {
        continue;
      }
      double lengths = 0.0;
      double weights = 0.0;
      for (int m = 0; m < this->Size(); ++m)
      {
        if (m != i && m != k && this->Between(i, m).Exists)
        {
          const double a = this->Between(i, m).Length;
          const double b = this->Between(k, m).Length;
          lengths += this->Weights[m] * std::abs(a - b) / std::max(a, b);
          weights += this->Weights[m];
        }
      }
      const double unlike = (weights > 0.0 ? lengths / weights : 0.0) +
        ProfileDistance(this->Tapers[i], this->Tapers[k]) +
        std::abs(features[this->Features[i]].AGD - features[this->Features[k]].AGD);
      path.Likeness = std::exp(-(unlike / TwinTolerance) * (unlike / TwinTolerance));
    }
  }
}

void TerminalPaths::FindTapers(double scale)
{
  const FeatureGraph& graph = this->Skeleton;
  for (int i = 0; i < this->Size(); ++i)
  {
    // Towards the terminals that are far: the longest path passes the centre.
    int farthest = -1;
    for (int k = 0; k < this->Size(); ++k)
    {
      if (this->Between(i, k).Exists &&
        (farthest < 0 || this->Between(i, k).Length > this->Between(i, farthest).Length))
      {
        farthest = k;
      }
    }
    std::vector<double> taper;
    if (farthest >= 0)
    {
      const Path& path = this->Between(i, farthest);
      const std::vector<double> profile =
        graph.Profile(path.Darts, FeatureGraph::Measure::MSP, TaperPieces);
      for (const double distance : TaperDistances)
      {
        // A path without length, as of a skeleton in one place, is all beginning.
        const double piece = path.Length > 0.0 ? distance * scale / path.Length * TaperPieces : 0.0;
        taper.push_back(std::sqrt(profile[static_cast<int>(std::min(piece, TaperPieces - 1.0))]));
      }
    }
    this->Tapers.push_back(taper);
  }
}

TerminalPaths::Mask TerminalPaths::Beyond(int dart) const
{
  const FeatureGraph& graph = this->Skeleton;
  Mask mask = 0;
  if (!graph.IsInForest(dart / 2))
  {
    return mask;
  }
  std::vector<bool> seen(graph.NumberOfFeatures(), false);
  std::vector<int> open{ graph.Head(dart) };
  seen[graph.Head(dart)] = true;
  while (!open.empty())
  {
    const int feature = open.back();
    open.pop_back();
    if (this->TerminalOfFeature[feature] >= 0)
    {
      mask |= Mask(1) << this->TerminalOfFeature[feature];
    }
    for (int next : graph.GetFeatures()[feature].Darts)
    {
      if (next / 2 != dart / 2 && graph.IsInForest(next / 2) && !seen[graph.Head(next)])
      {
        seen[graph.Head(next)] = true;
        open.push_back(graph.Head(next));
      }
    }
  }
  return mask;
}

void TerminalPaths::FindSplits()
{
  for (int branch = 0; branch < this->Skeleton.NumberOfBranches(); ++branch)
  {
    const Mask back = this->Beyond(2 * branch);
    const Mask front = this->Beyond(2 * branch + 1);
    const auto several = [](Mask mask) { return (mask & (mask - 1)) != 0; };
    if (several(back) && several(front))
    {
      const FeatureGraph& graph = this->Skeleton;
      const auto& a = graph.GetFeatures()[graph.Origin(2 * branch)];
      const auto& b = graph.GetFeatures()[graph.Head(2 * branch)];
      const double radius = 0.5 * (a.Radius + b.Radius) / graph.TotalLength();
      const double length = graph.Length(branch);
      this->Splits.push_back({ branch, back, length * length / (length + radius) });
    }
  }
}
}
