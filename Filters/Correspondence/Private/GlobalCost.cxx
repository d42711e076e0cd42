// SPDX-License-Identifier: BSD-3-Clause
#include "GlobalCost.h"

#include "LinearAssignment.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// Paths in different components on one side and in the same on the other.
constexpr double Impossible = 2.0;
/// Quadruples grow with the fourth power of this.
constexpr std::size_t MaximumHandedTerminals = 6;

/// Differences below the tolerance count little.
double Soften(double difference, double tolerance)
{
  return difference * difference / (difference + tolerance);
}

/// Signed volume of a tetrahedron over its mean edge cubed.
double Volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& d)
{
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const Eigen::Vector3d w = d - a;
  const double edge =
    (u.norm() + v.norm() + w.norm() + (v - u).norm() + (w - u).norm() + (w - v).norm()) / 6.0;
  return edge > 0.0 ? u.dot(v.cross(w)) / (edge * edge * edge) : 0.0;
}
}

GlobalCost::GlobalCost(const TerminalPaths& source, const TerminalPaths& target,
  const MatchingWeights& weights, const std::vector<NodeHint>& hints)
  : Source(source)
  , Target(target)
  , Weights(weights)
  , Hints(source, target, hints)
{
  const int sources = source.Size();
  const int targets = target.Size();
  this->TerminalTable.resize(sources * targets);
  this->PathTable.resize(this->TerminalTable.size() * this->TerminalTable.size());
  for (int i = 0; i < sources; ++i)
  {
    for (int j = 0; j < targets; ++j)
    {
      const double s = source.Graph().GetFeatures()[source.Feature(i)].AGD;
      const double t = target.Graph().GetFeatures()[target.Feature(j)].AGD;
      const std::vector<double>& a = source.Taper(i);
      const std::vector<double>& b = target.Taper(j);
      this->TerminalTable[i * targets + j] = weights.Centricity * std::abs(s - t) +
        weights.Taper * (a.size() == b.size() ? ProfileDistance(a, b) : 0.0);
    }
    for (int k = 0; k < sources; ++k)
    {
      const TerminalPaths::Path& s = source.Between(i, k);
      for (int j = 0; j < targets; ++j)
      {
        for (int l = 0; l < targets; ++l)
        {
          const TerminalPaths::Path& t = target.Between(j, l);
          double& cost = this->PathTable[((i * sources + k) * targets + j) * targets + l];
          if (!s.Exists || !t.Exists)
          {
            cost = s.Exists == t.Exists ? 0.0 : Impossible;
            continue;
          }
          cost = weights.Length *
              Soften(std::abs(s.Length - t.Length) / std::max(s.Length, t.Length),
                weights.LengthTolerance) +
            weights.Profile * ProfileDistance(s.Profile, t.Profile) +
            weights.Chord * ProfileDistance(s.Chords, t.Chords) +
            weights.Angle * std::abs(s.Angle - t.Angle) +
            weights.Twin * std::abs(s.Likeness - t.Likeness);
        }
      }
    }
  }
}

double GlobalCost::Intrinsic(const Assignment& targetOf) const
{
  const int targets = this->Target.Size();
  double cost = 0.0;
  double matchedSource = 0.0;
  double matchedTarget = 0.0;
  for (int i = 0; i < this->Source.Size(); ++i)
  {
    const int j = targetOf[i];
    if (j < 0)
    {
      continue;
    }
    matchedSource += this->Source.Weight(i);
    matchedTarget += this->Target.Weight(j);
    double unlike = 0.0;
    double weights = 0.0;
    for (int k = 0; k < this->Source.Size(); ++k)
    {
      const int l = targetOf[k];
      if (k != i && l >= 0)
      {
        const double weight = this->Source.Weight(k) + this->Target.Weight(l);
        unlike += weight * this->PathUnlike(i, k, j, l);
        weights += weight;
      }
    }
    const double weight = 0.5 * (this->Source.Weight(i) + this->Target.Weight(j));
    const double pair =
      this->TerminalTable[i * targets + j] + (weights > 0.0 ? unlike / weights : 0.0);
    cost += weight * pair / (1.0 + pair / this->Weights.Saturation);
  }
  cost += this->Weights.Unmatched * 0.5 * (2.0 - matchedSource - matchedTarget);
  return cost + this->Weights.Split * this->SplitCost(targetOf) +
    this->Weights.Pose * this->PoseCost(targetOf) + this->OfHints(targetOf);
}

double GlobalCost::PoseCost(const Assignment& targetOf) const
{
  Eigen::Vector3d sourceCenter = Eigen::Vector3d::Zero();
  Eigen::Vector3d targetCenter = Eigen::Vector3d::Zero();
  double weights = 0.0;
  const auto visit = [&](auto&& function)
  {
    for (int i = 0; i < this->Source.Size(); ++i)
    {
      if (targetOf[i] < 0)
      {
        continue;
      }
      const auto& s = this->Source.Points(i);
      const auto& t = this->Target.Points(targetOf[i]);
      for (std::size_t k = 0; k < s.size(); ++k)
      {
        function(this->Source.Weight(i) + this->Target.Weight(targetOf[i]), s[k], t[k]);
      }
    }
  };
  visit(
    [&](double weight, const Eigen::Vector3d& s, const Eigen::Vector3d& t)
    {
      sourceCenter += weight * s;
      targetCenter += weight * t;
      weights += weight;
    });
  if (!(weights > 0.0))
  {
    return 0.0;
  }
  sourceCenter /= weights;
  targetCenter /= weights;
  double sourceSquares = 0.0;
  double targetSquares = 0.0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  visit(
    [&](double weight, const Eigen::Vector3d& s, const Eigen::Vector3d& t)
    {
      sourceSquares += weight * (s - sourceCenter).squaredNorm();
      targetSquares += weight * (t - targetCenter).squaredNorm();
      covariance += weight * (s - sourceCenter) * (t - targetCenter).transpose();
    });
  const double norm = std::sqrt(sourceSquares * targetSquares);
  if (!(norm > 0.0))
  {
    return 0.0;
  }
  // The largest trace of a rotation times the covariance, by Horn's quaternions.
  const Eigen::Matrix3d& m = covariance;
  Eigen::Matrix4d horn;
  horn << m(0, 0) + m(1, 1) + m(2, 2), m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0),
    m(1, 2) - m(2, 1), m(0, 0) - m(1, 1) - m(2, 2), m(0, 1) + m(1, 0), m(2, 0) + m(0, 2),
    m(2, 0) - m(0, 2), m(0, 1) + m(1, 0), -m(0, 0) + m(1, 1) - m(2, 2), m(1, 2) + m(2, 1),
    m(0, 1) - m(1, 0), m(2, 0) + m(0, 2), m(1, 2) + m(2, 1), -m(0, 0) - m(1, 1) + m(2, 2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(horn, Eigen::EigenvaluesOnly);
  return 1.0 - solver.eigenvalues()[3] / norm;
}

double GlobalCost::SplitCost(const Assignment& targetOf) const
{
  using Mask = TerminalPaths::Mask;
  Mask matched = 0;
  Assignment sourceOf(this->Target.Size(), -1);
  for (int i = 0; i < this->Source.Size(); ++i)
  {
    if (targetOf[i] >= 0)
    {
      matched |= Mask(1) << i;
      sourceOf[targetOf[i]] = i;
    }
  }
  // A split in terms of the matched source terminals, the one of both sides without the first.
  const auto canonical = [&](Mask mask)
  {
    mask &= matched;
    return (mask & matched & (~matched + 1)) != 0 ? matched & ~mask : mask;
  };
  const auto trivial = [&](Mask mask) { return (mask & (mask - 1)) == 0; };
  std::vector<std::pair<Mask, double>> sourceSplits;
  std::vector<std::pair<Mask, double>> targetSplits;
  for (const auto& split : this->Source.GetSplits())
  {
    sourceSplits.emplace_back(canonical(split.Beyond), split.Cost);
  }
  for (const auto& split : this->Target.GetSplits())
  {
    Mask mask = 0;
    for (int j = 0; j < this->Target.Size(); ++j)
    {
      if (sourceOf[j] >= 0 && (split.Beyond >> j & 1) != 0)
      {
        mask |= Mask(1) << sourceOf[j];
      }
    }
    targetSplits.emplace_back(canonical(mask), split.Cost);
  }
  double cost = 0.0;
  for (const auto& [splits, others] :
    { std::pair{ &sourceSplits, &targetSplits }, std::pair{ &targetSplits, &sourceSplits } })
  {
    for (const auto& [mask, splitCost] : *splits)
    {
      // Also the complement may be a single terminal.
      if (trivial(mask) || trivial(matched & ~mask))
      {
        continue;
      }
      const Mask wanted = mask;
      if (std::none_of(others->begin(), others->end(),
            [&](const std::pair<Mask, double>& other) { return other.first == wanted; }))
      {
        cost += 0.5 * splitCost;
      }
    }
  }
  return cost;
}

double GlobalCost::Handedness(const Assignment& targetOf) const
{
  std::vector<std::pair<double, int>> matched;
  for (int i = 0; i < this->Source.Size(); ++i)
  {
    if (targetOf[i] >= 0)
    {
      matched.emplace_back(-this->Source.Weight(i) - this->Target.Weight(targetOf[i]), i);
    }
  }
  std::sort(matched.begin(), matched.end());
  if (matched.size() > MaximumHandedTerminals)
  {
    matched.resize(MaximumHandedTerminals);
  }
  std::vector<Eigen::Vector3d> s;
  std::vector<Eigen::Vector3d> t;
  for (const auto& entry : matched)
  {
    const auto& sourcePoints = this->Source.Points(entry.second);
    const auto& targetPoints = this->Target.Points(targetOf[entry.second]);
    s.insert(s.end(), sourcePoints.begin(), sourcePoints.end());
    t.insert(t.end(), targetPoints.begin(), targetPoints.end());
  }
  double product = 0.0;
  double squaredSource = 0.0;
  double squaredTarget = 0.0;
  for (std::size_t a = 0; a < s.size(); ++a)
  {
    for (std::size_t b = a + 1; b < s.size(); ++b)
    {
      for (std::size_t c = b + 1; c < s.size(); ++c)
      {
        for (std::size_t d = c + 1; d < s.size(); ++d)
        {
          const double vs = Volume(s[a], s[b], s[c], s[d]);
          const double vt = Volume(t[a], t[b], t[c], t[d]);
          product += vs * vt;
          squaredSource += vs * vs;
          squaredTarget += vt * vt;
        }
      }
    }
  }
  const double norm = std::sqrt(squaredSource * squaredTarget);
  return this->Weights.Handedness * 0.5 * (1.0 - (norm > 0.0 ? product / norm : 0.0));
}

GlobalCost::Assignment GlobalCost::Guess() const
{
  const int sources = this->Source.Size();
  const int targets = this->Target.Size();
  Eigen::MatrixXd cost(sources, targets);
  Eigen::MatrixXd paths(sources, targets);
  for (int i = 0; i < sources; ++i)
  {
    for (int j = 0; j < targets; ++j)
    {
      for (int k = 0; k < sources; ++k)
      {
        for (int l = 0; l < targets; ++l)
        {
          paths(k, l) = (k == i) != (l == j) ? Impossible : this->PathUnlike(i, k, j, l);
        }
      }
      const std::vector<int> columns = AssignRows(paths);
      double sum = 0.0;
      for (int k = 0; k < sources; ++k)
      {
        sum += columns[k] >= 0 ? paths(k, columns[k]) : 0.0;
      }
      cost(i, j) = this->TerminalTable[i * targets + j] + sum / std::min(sources, targets) +
        this->Hints.OfPair(i, j);
    }
  }
  return AssignRows(cost);
}
}
