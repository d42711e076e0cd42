// SPDX-License-Identifier: BSD-3-Clause
#include "BranchAssignment.h"

#include "Constants.h"
#include "LinearAssignment.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <set>

namespace marrow
{
namespace
{
/// 6!: up to six branches at a junction are tried in every order.
constexpr int MaximumEnumeration = 720;

double SquaredAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const double angle = std::acos(std::clamp(a.dot(b), -1.0, 1.0)) / Pi;
  return angle * angle;
}

/// Number of assignments of the fewer to the more, or something above the limit.
int NumberOfAssignments(int fewer, int more)
{
  int number = 1;
  for (int i = 0; i < fewer && number <= MaximumEnumeration; ++i)
  {
    number *= more - i;
  }
  return number;
}

/// Rates one assignment; false if it needs a reflection.
bool Rate(const BranchSets& sets, BranchAssignment& assignment)
{
  std::vector<Eigen::Vector3d> p = sets.KnownSource;
  std::vector<Eigen::Vector3d> q = sets.KnownTarget;
  for (std::size_t i = 0; i < sets.Source.size(); ++i)
  {
    const int j = assignment.TargetOfSource[i];
    if (j >= 0)
    {
      p.push_back(sets.Source[i]);
      q.push_back(sets.Target[j]);
      assignment.Unlikeness += sets.Unlikeness(static_cast<int>(i), j);
    }
  }
  Eigen::Matrix3d rotation;
  if (!BestRotation(p, q, rotation))
  {
    return false;
  }
  for (std::size_t i = sets.KnownSource.size(); i < p.size(); ++i)
  {
    assignment.SpatialCost += SquaredAngle(p[i], rotation * q[i]);
  }
  return true;
}

void Enumerate(const BranchSets& sets, bool sourceIsFewer, std::vector<int>& choice,
  std::vector<bool>& used, std::vector<BranchAssignment>& result)
{
  const std::size_t fewer = sourceIsFewer ? sets.Source.size() : sets.Target.size();
  if (choice.size() == fewer)
  {
    BranchAssignment assignment;
    assignment.TargetOfSource.assign(sets.Source.size(), -1);
    for (std::size_t i = 0; i < fewer; ++i)
    {
      const int source = sourceIsFewer ? static_cast<int>(i) : choice[i];
      assignment.TargetOfSource[source] = sourceIsFewer ? choice[i] : static_cast<int>(i);
    }
    if (Rate(sets, assignment))
    {
      result.push_back(std::move(assignment));
    }
    return;
  }
  for (std::size_t j = 0; j < used.size(); ++j)
  {
    if (!used[j])
    {
      used[j] = true;
      choice.push_back(static_cast<int>(j));
      Enumerate(sets, sourceIsFewer, choice, used, result);
      choice.pop_back();
      used[j] = false;
    }
  }
}

/// The best assignment under a given rotation of the target.
std::vector<int> AssignUnder(const BranchSets& sets, const Eigen::Matrix3d& rotation)
{
  Eigen::MatrixXd cost = sets.Unlikeness;
  for (Eigen::Index j = 0; j < cost.cols(); ++j)
  {
    const Eigen::Vector3d rotated = rotation * sets.Target[j];
    for (Eigen::Index i = 0; i < cost.rows(); ++i)
    {
      cost(i, j) += SquaredAngle(sets.Source[i], rotated);
    }
  }
  return AssignRows(cost);
}

std::vector<BranchAssignment> AssignByRotations(const BranchSets& sets)
{
  std::set<std::vector<int>> seen;
  std::vector<BranchAssignment> result;
  const int sources = static_cast<int>(sets.Source.size());
  const int targets = static_cast<int>(sets.Target.size());
  // The branch that is matched already is one of the two that fix a rotation.
  const int known = sets.KnownSource.empty() ? 0 : 1;
  for (int a = -known; a < (known ? 0 : sources); ++a)
  {
    for (int c = -known; c < (known ? 0 : targets); ++c)
    {
      for (int b = 0; b < sources; ++b)
      {
        for (int d = 0; d < targets; ++d)
        {
          if (a == b || c == d)
          {
            continue;
          }
          Eigen::Matrix3d rotation;
          BestRotation({ a < 0 ? sets.KnownSource[0] : sets.Source[a], sets.Source[b] },
            { c < 0 ? sets.KnownTarget[0] : sets.Target[c], sets.Target[d] }, rotation);
          BranchAssignment assignment;
          assignment.TargetOfSource = AssignUnder(sets, rotation);
          if (seen.insert(assignment.TargetOfSource).second && Rate(sets, assignment))
          {
            result.push_back(std::move(assignment));
          }
        }
      }
    }
  }
  return result;
}
}

bool BestRotation(const std::vector<Eigen::Vector3d>& source,
  const std::vector<Eigen::Vector3d>& target, Eigen::Matrix3d& rotation)
{
  // The sign of a reflection means something only if the vectors fill space; three branches in one
  // plane can always be turned over.
  constexpr double flat = 0.05;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    covariance += source[i] * target[i].transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d& values = svd.singularValues();
  rotation =
    svd.matrixU() * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
  return sign > 0.0 || values[2] <= flat * values[0];
}

double SpatialCost(
  const std::vector<Eigen::Vector3d>& source, const std::vector<Eigen::Vector3d>& target)
{
  Eigen::Matrix3d rotation;
  BestRotation(source, target, rotation);
  double cost = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    cost += SquaredAngle(source[i], rotation * target[i]);
  }
  return cost;
}

std::vector<BranchAssignment> FindAssignments(const BranchSets& sets)
{
  const int sources = static_cast<int>(sets.Source.size());
  const int targets = static_cast<int>(sets.Target.size());
  if (std::min(sources, targets) == 0)
  {
    return {};
  }
  const int fewer = std::min(sources, targets);
  const int more = std::max(sources, targets);
  if (NumberOfAssignments(fewer, more) > MaximumEnumeration)
  {
    return AssignByRotations(sets);
  }
  std::vector<BranchAssignment> result;
  std::vector<int> choice;
  std::vector<bool> used(more, false);
  Enumerate(sets, sources <= targets, choice, used, result);
  return result;
}
}
