// SPDX-License-Identifier: BSD-3-Clause
#include "SliceAlignment.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace marrow
{
namespace
{
/// What it costs to stay on a slice while the other chain goes on, so that equal slices are stretched
/// evenly; anything from 0.02 to 0.1 does.
constexpr double StretchCost = 0.05;

enum class Step
{
  Both,
  Source,
  Target
};
}

SliceAlignment::SliceAlignment(const SliceChain& source, const SliceChain& target, bool isTurned)
  : Source(source)
  , Target(target)
  , IsTurned(isTurned)
{
  this->Align();
}

void SliceAlignment::Align()
{
  const auto& sources = this->Source.GetSlices();
  const auto& targets = this->Target.GetSlices();
  const int n = static_cast<int>(sources.size());
  const int m = static_cast<int>(targets.size());
  const double sourceSize = this->Source.TypicalRadius();
  const double targetSize = this->Target.TypicalRadius();
  constexpr double least = 1e-9; // keeps the logarithm finite
  const auto logRadius = [](const SliceChain::Slice& slice, double size)
  { return std::log(std::max(slice.Radius, least * size) / std::max(size, 1e-300)); };
  // The slice of the source that is the i-th as the target is gone through.
  const auto sourceIndex = [&](int i) { return this->IsTurned ? n - 1 - i : i; };
  Eigen::MatrixXd costs(n, m);
  for (int i = 0; i < n; ++i)
  {
    const SliceChain::Slice& s = sources[sourceIndex(i)];
    const double slope = this->IsTurned ? -s.Slope : s.Slope;
    for (int j = 0; j < m; ++j)
    {
      const SliceChain::Slice& t = targets[j];
      costs(i, j) = std::min(1.0,
        std::abs(logRadius(s, sourceSize) - logRadius(t, targetSize)) + std::abs(slope - t.Slope));
    }
  }

  // A step on both counts for two slices, so that a path costs the same whatever its shape.
  Eigen::MatrixXd sums =
    Eigen::MatrixXd::Constant(n + 1, m + 1, std::numeric_limits<double>::infinity());
  sums(0, 0) = 0.0;
  std::vector<std::vector<Step>> steps(n, std::vector<Step>(m, Step::Both));
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const double cost = costs(i, j);
      double sum = sums(i, j) + 2.0 * cost;
      const double onSource = sums(i, j + 1) + cost + StretchCost;
      const double onTarget = sums(i + 1, j) + cost + StretchCost;
      if (onSource < sum)
      {
        sum = onSource;
        steps[i][j] = Step::Source;
      }
      if (onTarget < sum)
      {
        sum = onTarget;
        steps[i][j] = Step::Target;
      }
      sums(i + 1, j + 1) = sum;
    }
  }
  this->Cost = std::min(1.0, sums(n, m) / (n + m));

  // Of several slices that correspond to one, the most similar.
  this->SourceSlices.assign(m, 0);
  std::vector<double> bestCosts(m, std::numeric_limits<double>::infinity());
  for (int i = n - 1, j = m - 1; i >= 0 && j >= 0;)
  {
    if (costs(i, j) < bestCosts[j])
    {
      bestCosts[j] = costs(i, j);
      this->SourceSlices[j] = sourceIndex(i);
    }
    const Step step = steps[i][j];
    i -= step == Step::Target ? 0 : 1;
    j -= step == Step::Source ? 0 : 1;
  }
}

Eigen::Matrix3d SliceAlignment::GetRotation() const
{
  Eigen::Matrix3d between =
    Eigen::AngleAxisd(this->Angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  if (this->IsTurned)
  {
    between.rightCols<2>() *= -1.0;
  }
  return this->Source.GetFrame() * between * this->Target.GetFrame().transpose();
}

Eigen::Vector3d SliceAlignment::ToSource(const Eigen::Vector3d& point) const
{
  const double place = this->Target.PlaceOf(point);
  const int slice =
    std::clamp(static_cast<int>(place), 0, static_cast<int>(this->SourceSlices.size()) - 1);
  const double within = std::clamp(place - slice, 0.0, 1.0);
  const double there = this->SourceSlices[slice] + (this->IsTurned ? 1.0 - within : within);
  const double radius = this->Target.RadiusAt(place);
  const double ratio = radius > 0.0 ? this->Source.RadiusAt(there) / radius : 1.0;
  return this->Source.PointAt(there, ratio * (this->GetRotation() * this->Target.OffsetOf(point)));
}
}
