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
/// What a node without a partner costs, in units of the tolerances. Skeletons that are alike may well
/// have split a junction in two.
constexpr double TerminalLeftOut = 1.5;
constexpr double JunctionLeftOut = 0.75;

enum class Kind
{
  Terminal,
  Junction,
  OfRing ///< of a ring without either
};

const Eigen::Vector3d& PositionOf(const FeaturePaths& paths, int feature)
{
  return paths.Graph().GetFeatures()[paths.Feature(feature)].Position;
}

Kind KindOf(const FeaturePaths& paths, int feature)
{
  const FeatureGraph::Feature& f = paths.Graph().GetFeatures()[paths.Feature(feature)];
  return f.IsTerminal() ? Kind::Terminal : (f.IsJunction() ? Kind::Junction : Kind::OfRing);
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
  /// The tolerances are doubled twice at most: beyond that all nodes pass.
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
    if (!Report(progress, static_cast<double>(depth) / order.size()))
    {
      return false;
    }
    this->Electors = this->NextLevel(order[depth]);
    this->Statistics.TreeNodes += static_cast<int>(this->Electors.size());
    this->Statistics.Height = static_cast<int>(depth) + 1;
  }
  this->Statistics.Leaves = static_cast<int>(this->Electors.size());
  return true;
}

std::vector<ElectorsVoting::PairSet> ElectorsVoting::NextLevel(int feature)
{
  constexpr int none = -1;
  struct Child
  {
    const PairSet* Parent;
    int Partner;
    Rating Rated;
  };
  const double leftOut =
    KindOf(this->Source, feature) == Kind::Junction ? JunctionLeftOut : TerminalLeftOut;
  std::vector<int> partners;
  for (int t = 0; t < this->Target.Size(); ++t)
  {
    if (this->PassesCentricity({ feature, t }))
    {
      partners.push_back(t);
    }
  }
  this->Statistics.CorePairs += static_cast<int>(partners.size());
  std::vector<Child> children;
  for (const PairSet& set : this->Electors)
  {
    Child child{ &set, none, set.Rated };
    child.Rated.Misfit += leftOut;
    child.Rated.Rank += leftOut;
    children.push_back(child);
    for (const int t : partners)
    {
      child.Partner = t;
      if (this->Extend(set, { feature, t }, child.Rated))
      {
        children.push_back(child);
      }
    }
  }
  std::stable_sort(children.begin(), children.end(),
    [](const Child& a, const Child& b) { return a.Rated.Rank < b.Rated.Rank; });
  children.resize(std::min(children.size(), MaximumSets));
  std::vector<PairSet> next;
  for (const Child& child : children)
  {
    next.push_back({ child.Parent->Pairs, child.Rated });
    if (child.Partner != none)
    {
      next.back().Pairs.emplace_back(feature, child.Partner);
    }
  }
  return next;
}

bool ElectorsVoting::PassesCentricity(Pair pair) const
{
  return KindOf(this->Source, pair.first) == KindOf(this->Target, pair.second) &&
    std::abs(AGDOf(this->Source, pair.first) - AGDOf(this->Target, pair.second)) <=
    this->Relaxation * this->Parameters.CentricityTolerance;
}

bool ElectorsVoting::Extend(const PairSet& set, Pair added, Rating& rating) const
{
  const auto [s, t] = added;
  const double centricityTolerance = this->Relaxation * this->Parameters.CentricityTolerance;
  const double pathTolerance = this->Relaxation * this->Parameters.PathTolerance;
  double paths = 0.0;
  for (const auto& [u, v] : set.Pairs)
  {
    const double a = this->Source.Length(s, u);
    const double b = this->Target.Length(t, v);
    // Infinite: another component; the partners must be in two then too.
    const double unlike = a == b ? 0.0 : std::abs(a - b);
    if (u == s || v == t || !(unlike <= pathTolerance))
    {
      return false;
    }
    paths += unlike;
  }
  if (!this->PassesTopology(set, added))
  {
    return false;
  }
  rating = set.Rated;
  this->AddPositions(added, rating);
  const double spatial = SpatialMisfit(rating);
  if (spatial < 0.0 || spatial > this->Parameters.SpatialTolerance)
  {
    return false;
  }
  // All in units of the tolerances; where one is 0, so is the misfit.
  const auto relative = [](double misfit, double tolerance)
  { return tolerance > 0.0 ? misfit / tolerance : 0.0; };
  rating.Misfit +=
    relative(std::abs(AGDOf(this->Source, s) - AGDOf(this->Target, t)), centricityTolerance);
  if (!set.Pairs.empty())
  {
    rating.Misfit += relative(paths / set.Pairs.size(), pathTolerance);
  }
  rating.Rank = rating.Misfit + rating.Count * relative(spatial, this->Parameters.SpatialTolerance);
  return true;
}

bool ElectorsVoting::PassesTopology(const PairSet& set, Pair added) const
{
  const auto holds = [](FeaturePaths::Mask mask, int feature)
  { return (mask >> feature & 1) != 0; };
  const auto alike = [&](const Pair& a, const Pair& middle, const Pair& b)
  {
    return holds(this->Source.Between(a.first, b.first), middle.first) ==
      holds(this->Target.Between(a.second, b.second), middle.second) ||
      (holds(this->Source.Near(a.first, b.first), middle.first) &&
        holds(this->Target.Near(a.second, b.second), middle.second));
  };
  for (std::size_t i = 0; i < set.Pairs.size(); ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      const Pair& a = set.Pairs[i];
      const Pair& b = set.Pairs[k];
      if (!alike(a, added, b) || !alike(added, a, b) || !alike(added, b, a))
      {
        return false;
      }
    }
  }
  return true;
}

void ElectorsVoting::AddPositions(Pair added, Rating& rating) const
{
  const Eigen::Vector3d& p = PositionOf(this->Source, added.first);
  const Eigen::Vector3d& q = PositionOf(this->Target, added.second);
  ++rating.Count;
  rating.SourceSum += p;
  rating.TargetSum += q;
  rating.Products += p * q.transpose();
  rating.SourceSquares += p.squaredNorm();
  rating.TargetSquares += q.squaredNorm();
}

double ElectorsVoting::SpatialMisfit(const Rating& rating)
{
  // As of the branch vectors of a junction (BranchAssignment): flat sets can be turned over.
  constexpr double flat = 0.05;
  const double count = rating.Count;
  if (rating.Count < 3)
  {
    return 0.0;
  }
  const Eigen::Matrix3d covariance =
    rating.Products - rating.SourceSum * rating.TargetSum.transpose() / count;
  const double spread = std::sqrt((rating.SourceSquares - rating.SourceSum.squaredNorm() / count) *
    (rating.TargetSquares - rating.TargetSum.squaredNorm() / count));
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
  const double explained =
    (singular[2] + singular[1] + (reflects ? -1.0 : 1.0) * singular[0]) / spread;
  return std::max(0.0, 1.0 - explained);
}

ElectorsVoting::PairSet ElectorsVoting::Elect() const
{
  const int targets = this->Target.Size();
  struct Candidate
  {
    Pair Features;
    int Votes = 0;
    double BestRank = std::numeric_limits<double>::infinity();
  };
  std::vector<Candidate> candidates(this->Source.Size() * targets);
  for (const PairSet& elector : this->Electors)
  {
    for (const Pair& pair : elector.Pairs)
    {
      Candidate& candidate = candidates[pair.first * targets + pair.second];
      candidate.Features = pair;
      ++candidate.Votes;
      candidate.BestRank = std::min(candidate.BestRank, elector.Rated.Rank);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return a.Votes != b.Votes ? a.Votes > b.Votes : a.BestRank < b.BestRank; });
  PairSet winner;
  for (const Candidate& candidate : candidates)
  {
    Rating extended;
    if (candidate.Votes > 0 && this->Extend(winner, candidate.Features, extended))
    {
      winner.Pairs.push_back(candidate.Features);
      winner.Rated = extended;
    }
  }
  return winner;
}
}
