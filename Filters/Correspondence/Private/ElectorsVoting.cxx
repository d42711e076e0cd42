// SPDX-License-Identifier: BSD-3-Clause
#include "ElectorsVoting.h"

#include "NodeConsensus.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace marrow
{
namespace
{
constexpr double LeftOut = 1.5;

bool Holds(FeaturePaths::Mask mask, int feature)
{
  return (mask >> feature & 1) != 0;
}

const Eigen::Vector3d& PositionOf(const FeaturePaths& paths, int feature)
{
  return paths.Graph().GetFeatures()[paths.Feature(feature)].Position;
}

/// 0: terminal, 1: junction, 2: the node of a ring without either.
int KindOf(const FeaturePaths& paths, int feature)
{
  const FeatureGraph::Feature& f = paths.Graph().GetFeatures()[paths.Feature(feature)];
  return f.IsTerminal() ? 0 : (f.IsJunction() ? 1 : 2);
}

double AGDOf(const FeaturePaths& paths, int feature)
{
  return paths.Graph().GetFeatures()[paths.Feature(feature)].AGD;
}
}

ElectorsVoting::ElectorsVoting(
  const FeatureGraph& source, const FeatureGraph& target, const VotingParameters& parameters)
  : Source(source)
  , Target(target)
  , Parameters(parameters)
{
}

bool ElectorsVoting::Vote(const Progress& progress)
{
  constexpr int attempts = 3;
  const std::size_t possible = std::min(this->Source.Size(), this->Target.Size());
  PairSet winner;
  for (int attempt = 0; attempt < attempts && 2 * winner.Pairs.size() < possible; ++attempt)
  {
    this->Relaxation = std::pow(2.0, attempt);
    this->Statistics = TreeStatistics();
    if (!this->Search(SubProgress(
          progress, static_cast<double>(attempt) / attempts, (attempt + 1.0) / attempts)))
    {
      return false;
    }
    winner = this->Elect();
  }
  this->Match = MatchByNodes(this->Source, this->Target, winner.Pairs);
  this->Statistics.Merges = this->Match.Merges;
  return Report(progress, 1.0);
}

std::vector<int> ElectorsVoting::SearchOrder() const
{
  const FeatureGraph& graph = this->Source.Graph();
  const auto weight = [&](int feature)
  { return graph.Length(graph.GetFeatures()[this->Source.Feature(feature)].Darts); };
  std::vector<int> order(this->Source.Size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return weight(a) > weight(b); });
  return order;
}

bool ElectorsVoting::Search(const Progress& progress)
{
  const std::vector<int> order = this->SearchOrder();
  this->Electors.assign(1, PairSet());
  for (std::size_t depth = 0; depth < order.size(); ++depth)
  {
    std::vector<int> partners;
    for (int t = 0; t < this->Target.Size(); ++t)
    {
      if (this->PassesCentricity({ order[depth], t }))
      {
        partners.push_back(t);
      }
    }
    this->Statistics.CorePairs += static_cast<int>(partners.size());
    std::vector<PairSet> next;
    for (const PairSet& set : this->Electors)
    {
      if (!Report(progress, static_cast<double>(depth) / order.size()))
      {
        return false;
      }
      for (const int t : partners)
      {
        PairSet extended;
        if (this->Extend(set, { order[depth], t }, extended))
        {
          next.push_back(std::move(extended));
        }
      }
      next.push_back(set);
      next.back().Misfit += LeftOut;
      next.back().Rank += LeftOut;
    }
    std::stable_sort(
      next.begin(), next.end(), [](const PairSet& a, const PairSet& b) { return a.Rank < b.Rank; });
    if (next.size() > MaximumSets)
    {
      next.resize(MaximumSets);
    }
    this->Statistics.TreeNodes += static_cast<int>(next.size());
    this->Statistics.Height = static_cast<int>(depth) + 1;
    this->Electors = std::move(next);
  }
  this->Statistics.Leaves = static_cast<int>(this->Electors.size());
  return true;
}

bool ElectorsVoting::PassesCentricity(Pair pair) const
{
  return KindOf(this->Source, pair.first) == KindOf(this->Target, pair.second) &&
    std::abs(AGDOf(this->Source, pair.first) - AGDOf(this->Target, pair.second)) <=
    this->Relaxation * this->Parameters.CentricityTolerance;
}

bool ElectorsVoting::Extend(const PairSet& set, Pair added, PairSet& result) const
{
  const auto [s, t] = added;
  double paths = 0.0;
  for (const auto& [u, v] : set.Pairs)
  {
    const double a = this->Source.Length(s, u);
    const double b = this->Target.Length(t, v);
    // Infinite: another component; the partners must be in two then too.
    const double unlike = a == b ? 0.0 : std::abs(a - b);
    if (v == t || !(unlike <= this->Relaxation * this->Parameters.PathTolerance))
    {
      return false;
    }
    paths += unlike;
  }
  if (!this->PassesTopology(set, added))
  {
    return false;
  }
  result = set;
  result.Misfit += std::abs(AGDOf(this->Source, s) - AGDOf(this->Target, t)) /
    (this->Relaxation * this->Parameters.CentricityTolerance);
  if (!set.Pairs.empty())
  {
    result.Misfit += paths / (set.Pairs.size() * this->Relaxation * this->Parameters.PathTolerance);
  }
  result.Pairs.push_back(added);
  this->AddPositions(result, added);
  const double spatial = SpatialMisfit(result);
  if (spatial < 0.0 || spatial > this->Parameters.SpatialTolerance)
  {
    return false;
  }
  result.Rank = result.Misfit +
    static_cast<double>(result.Pairs.size()) * spatial / this->Parameters.SpatialTolerance;
  return true;
}

bool ElectorsVoting::PassesTopology(const PairSet& set, Pair added) const
{
  const auto [s, t] = added;
  for (std::size_t i = 0; i < set.Pairs.size(); ++i)
  {
    const auto [u, v] = set.Pairs[i];
    const FeaturePaths::Mask sourceMask = this->Source.Between(s, u);
    const FeaturePaths::Mask targetMask = this->Target.Between(t, v);
    for (std::size_t k = 0; k < set.Pairs.size(); ++k)
    {
      const auto [w, x] = set.Pairs[k];
      if (Holds(sourceMask, w) != Holds(targetMask, x) ||
        (k < i && Holds(this->Source.Between(u, w), s) != Holds(this->Target.Between(v, x), t)))
      {
        return false;
      }
    }
  }
  return true;
}

void ElectorsVoting::AddPositions(PairSet& set, Pair added) const
{
  const Eigen::Vector3d& p = PositionOf(this->Source, added.first);
  const Eigen::Vector3d& q = PositionOf(this->Target, added.second);
  set.SourceSum += p;
  set.TargetSum += q;
  set.Products += p * q.transpose();
  set.SourceSquares += p.squaredNorm();
  set.TargetSquares += q.squaredNorm();
}

double ElectorsVoting::SpatialMisfit(const PairSet& set)
{
  // As of the branch vectors of a junction (BranchAssignment): flat sets can be turned over.
  constexpr double flat = 0.05;
  const double count = static_cast<double>(set.Pairs.size());
  if (count < 3.0)
  {
    return 0.0;
  }
  const Eigen::Matrix3d covariance =
    set.Products - set.SourceSum * set.TargetSum.transpose() / count;
  const double spread = std::sqrt((set.SourceSquares - set.SourceSum.squaredNorm() / count) *
    (set.TargetSquares - set.TargetSum.squaredNorm() / count));
  if (!(spread > 0.0))
  {
    return 0.0;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance.transpose() * covariance, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d singular = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const bool reflects = covariance.determinant() < 0.0;
  if (reflects && singular[0] > flat * singular[2])
  {
    return -1.0;
  }
  return 1.0 - (singular[2] + singular[1] + (reflects ? -1.0 : 1.0) * singular[0]) / spread;
}

ElectorsVoting::PairSet ElectorsVoting::Elect() const
{
  Eigen::MatrixXi votes = Eigen::MatrixXi::Zero(this->Source.Size(), this->Target.Size());
  for (const PairSet& elector : this->Electors)
  {
    for (const auto& [s, t] : elector.Pairs)
    {
      ++votes(s, t);
    }
  }
  const PairSet* winner = nullptr;
  long long most = -1;
  // The electors stand in the order of their rank.
  for (const PairSet& elector : this->Electors)
  {
    long long sum = 0;
    for (const auto& [s, t] : elector.Pairs)
    {
      sum += votes(s, t);
    }
    if (sum > most)
    {
      most = sum;
      winner = &elector;
    }
  }
  return winner ? *winner : PairSet();
}
}
