// SPDX-License-Identifier: BSD-3-Clause
#include "ChainAlignment.h"

#include "MatchedSkeletons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
/// Of a chain; finer ones move boundaries by less than a face.
constexpr int Steps = 48;
/// Weights of the warping's cost beside the difference of thickness: of uneven stretching, of how the surface
/// fills a tube, of missing a landmark. Chosen on labelled meshes.
constexpr double StretchWeight = 0.25;
constexpr double FillWeight = 1.0;
constexpr double LandmarkWeight = 0.25;
/// Of the diagonal: a logarithm of nothing would outweigh all else.
constexpr double LeastThickness = 1e-6;
/// Keeps a mean of weights finite where no node is near.
constexpr double NoGap = 1e-9;
/// A difference of profiles beyond which places are just different.
constexpr double LargestDifference = 1.5;

struct Profile
{
  std::array<double, Steps + 1> Thickness; ///< log MSP
  std::array<double, Steps + 1> Fill;      ///< in [0,1]
};

double Interpolate(
  const std::vector<std::pair<double, double>>& knots, double value, bool fromSource)
{
  const auto x = [fromSource](const std::pair<double, double>& knot)
  { return fromSource ? knot.first : knot.second; };
  const auto y = [fromSource](const std::pair<double, double>& knot)
  { return fromSource ? knot.second : knot.first; };
  for (std::size_t k = 1; k < knots.size(); ++k)
  {
    if (value <= x(knots[k]) || k + 1 == knots.size())
    {
      const double width = x(knots[k]) - x(knots[k - 1]);
      const double t = width > 0.0 ? (value - x(knots[k - 1])) / width : 0.0;
      return std::clamp(y(knots[k - 1]) + t * (y(knots[k]) - y(knots[k - 1])), 0.0, 1.0);
    }
  }
  return value;
}

Profile ProfileOf(const AnalyzedMesh& side, const std::vector<double>& area, const Branch& chain)
{
  // Per node: the area of its φ over that of the tube it stands for.
  const int size = static_cast<int>(chain.Nodes.size());
  std::vector<double> fill(size, 0.0);
  std::vector<double> thickness(size, 0.0);
  for (int i = 0; i < size; ++i)
  {
    const SkeletonNode& node = side.Skeleton.Graph[chain.Nodes[i]];
    const double before = chain.ArcLength[std::max(i - 1, 0)];
    const double after = chain.ArcLength[std::min(i + 1, size - 1)];
    const double tube = 0.5 * (after - before) * node.MSP;
    double own = 0.0;
    for (const int v : node.Vertices)
    {
      own += area[v];
    }
    fill[i] = tube > 0.0 ? std::min(own / tube, 1.0) : 1.0;
    thickness[i] = std::log(std::max(node.MSP, LeastThickness * side.Diagonal()));
  }

  // Smoothed over a few steps: single nodes are noisy.
  Profile profile;
  const double length = std::max(chain.Length(), 1e-300);
  const double width = 1.5 / Steps;
  for (int k = 0; k <= Steps; ++k)
  {
    const double at = static_cast<double>(k) / Steps;
    double total = 0.0;
    double sumThickness = 0.0;
    double sumFill = 0.0;
    for (int i = 0; i < size; ++i)
    {
      const double distance = (chain.ArcLength[i] / length - at) / width;
      const double before = chain.ArcLength[std::max(i - 1, 0)];
      const double after = chain.ArcLength[std::min(i + 1, size - 1)];
      const double weight =
        (std::exp(-0.5 * distance * distance) + NoGap) * (0.5 * (after - before) + NoGap * length);
      total += weight;
      sumThickness += weight * thickness[i];
      sumFill += weight * fill[i];
    }
    profile.Thickness[k] = sumThickness / total;
    profile.Fill[k] = sumFill / total;
  }
  return profile;
}

/// The constant by which one logarithmic profile lies above the other: the median over equal ratios.
double Offset(const Profile& source, const Profile& target)
{
  std::array<double, Steps + 1> differences;
  for (int k = 0; k <= Steps; ++k)
  {
    differences[k] = source.Thickness[k] - target.Thickness[k];
  }
  std::nth_element(differences.begin(), differences.begin() + Steps / 2, differences.end());
  return differences[Steps / 2];
}
}

double ChainAlignment::TargetRatio(double sourceRatio) const
{
  return Interpolate(this->Knots, sourceRatio, true);
}

double ChainAlignment::SourceRatio(double targetRatio) const
{
  return Interpolate(this->Knots, targetRatio, false);
}

ChainAlignment AlignChains(const AnalyzedMesh& source, const Branch& sourceChain,
  const AnalyzedMesh& target, const Branch& targetChain, const std::optional<Landmark>& landmark)
{
  const Profile s = ProfileOf(source, source.Mesh.VertexAreas(), sourceChain);
  const Profile t = ProfileOf(target, target.Mesh.VertexAreas(), targetChain);
  const double offset = Offset(s, t);
  const auto difference = [&](int i, int j)
  {
    double cost = std::min(std::abs(s.Thickness[i] - t.Thickness[j] - offset), LargestDifference) +
      FillWeight * std::abs(s.Fill[i] - t.Fill[j]);
    if (landmark)
    {
      // A place near the one end of a landmark has to be as near to its other end.
      const double a = (static_cast<double>(i) / Steps - landmark->Source) * Steps / 3.0;
      const double b = (static_cast<double>(j) / Steps - landmark->Target) * Steps / 3.0;
      cost += LandmarkWeight * std::abs(std::exp(-0.5 * a * a) - std::exp(-0.5 * b * b));
    }
    return cost;
  };

  /// Of dynamic time warping: a piece is stretched to four times its length at most.
  constexpr std::array<std::pair<int, int>, 9> moves = { { { 1, 1 }, { 1, 2 }, { 2, 1 }, { 1, 3 },
    { 3, 1 }, { 2, 3 }, { 3, 2 }, { 1, 4 }, { 4, 1 } } };
  constexpr int side = Steps + 1; // of the table
  std::vector<double> best(side * side, std::numeric_limits<double>::infinity());
  std::vector<int> from(side * side, -1);
  best[0] = 0.0;
  for (int i = 1; i <= Steps; ++i)
  {
    for (int j = 1; j <= Steps; ++j)
    {
      const double here = difference(i, j);
      for (std::size_t m = 0; m < moves.size(); ++m)
      {
        const auto [di, dj] = moves[m];
        if (i < di || j < dj)
        {
          continue;
        }
        const double length = 0.5 * (di + dj);
        const double cost = best[(i - di) * side + j - dj] +
          length * (here + StretchWeight * std::abs(std::log(static_cast<double>(di) / dj)));
        if (cost < best[i * side + j])
        {
          best[i * side + j] = cost;
          from[i * side + j] = static_cast<int>(m);
        }
      }
    }
  }

  std::vector<std::pair<double, double>> knots;
  for (int i = Steps, j = Steps; i > 0 || j > 0;)
  {
    knots.emplace_back(static_cast<double>(i) / Steps, static_cast<double>(j) / Steps);
    const auto [di, dj] = moves[from[i * side + j]];
    i -= di;
    j -= dj;
  }
  knots.emplace_back(0.0, 0.0);
  std::reverse(knots.begin(), knots.end());
  return ChainAlignment(std::move(knots));
}
}
