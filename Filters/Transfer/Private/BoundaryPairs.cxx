// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryPairs.h"

#include "BoundaryTransfer.h"

#include <algorithm>
#include <limits>

namespace marrow
{
namespace
{
/// A closed polyline with its lengths.
struct ClosedLine
{
  std::vector<Eigen::Vector3d> Points;
  std::vector<double> Arc; ///< fraction of the length at each point, then 1

  explicit ClosedLine(std::vector<Eigen::Vector3d> points)
    : Points(std::move(points))
    , Arc(1, 0.0)
  {
    const std::size_t n = this->Points.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      this->Arc.push_back(this->Arc.back() + (this->Points[(i + 1) % n] - this->Points[i]).norm());
    }
    const double length = std::max(this->Arc.back(), 1e-300);
    for (double& arc : this->Arc)
    {
      arc /= length;
    }
  }

  /// Index of the segment that holds a fraction, and how far along it.
  std::pair<std::size_t, double> Locate(double fraction) const
  {
    const auto above = std::upper_bound(this->Arc.begin(), this->Arc.end(), fraction);
    const std::size_t last = this->Points.size() - 1;
    const std::size_t i = std::min(
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - this->Arc.begin() - 1, 0)), last);
    const double span = this->Arc[i + 1] - this->Arc[i];
    return { i, span > 0.0 ? std::clamp((fraction - this->Arc[i]) / span, 0.0, 1.0) : 0.0 };
  }
};

Eigen::Vector3d Blend(
  const std::vector<Eigen::Vector3d>& points, const std::pair<std::size_t, double>& at)
{
  return (1.0 - at.second) * points[at.first] + at.second * points[(at.first + 1) % points.size()];
}

std::vector<Eigen::Vector3d> Gather(
  const std::vector<Eigen::Vector3d>& points, const std::vector<int>& vertices)
{
  std::vector<Eigen::Vector3d> result;
  result.reserve(vertices.size());
  for (int v : vertices)
  {
    result.push_back(points[v]);
  }
  return result;
}

Eigen::Vector3d Mean(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& point : points)
  {
    sum += point;
  }
  return sum / static_cast<double>(std::max<std::size_t>(points.size(), 1));
}

/// Points of the target's line for the points of the source's; `mapped` are the target's points in
/// the source's space.
std::vector<Eigen::Vector3d> Correspond(const std::vector<Eigen::Vector3d>& sourcePoints,
  const std::vector<Eigen::Vector3d>& targetPoints, const std::vector<Eigen::Vector3d>& mapped)
{
  const ClosedLine source(sourcePoints);
  const ClosedLine target(targetPoints);
  constexpr int numberOfStarts =
    64; // that are tried for points to correspond: some 6 degrees apart
  double least = std::numeric_limits<double>::infinity();
  double bestStart = 0.0;
  for (int k = 0; k < numberOfStarts; ++k)
  {
    const double start = static_cast<double>(k) / numberOfStarts;
    double sum = 0.0;
    for (std::size_t i = 0; i < sourcePoints.size(); ++i)
    {
      double at = source.Arc[i] + start;
      at -= at >= 1.0 ? 1.0 : 0.0;
      sum += (Blend(mapped, target.Locate(at)) - sourcePoints[i]).squaredNorm();
    }
    if (sum < least)
    {
      least = sum;
      bestStart = start;
    }
  }
  std::vector<Eigen::Vector3d> result;
  for (std::size_t i = 0; i < sourcePoints.size(); ++i)
  {
    double at = source.Arc[i] + bestStart;
    at -= at >= 1.0 ? 1.0 : 0.0;
    result.push_back(Blend(targetPoints, target.Locate(at)));
  }
  return result;
}
}

std::vector<BoundaryPair> PairsOfLoops(const AnalyzedMesh& source, const MatchedSkeletons& match,
  const SegmentPieces& pieces, const std::vector<SegmentLoop>& loops)
{
  std::vector<BoundaryPair> pairs(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    pairs[i].LeftLabel = pieces.LabelOfPiece[loops[i].LeftPiece];
    pairs[i].RightLabel = pieces.LabelOfPiece[loops[i].RightPiece];
    pairs[i].SourcePoints = Gather(source.Mesh.Points, loops[i].Vertices(source.Mesh));
    pairs[i].EnclosesBranch = FindSeat(source, match, loops[i]).has_value();
  }
  return pairs;
}

void FindTargetBoundaries(const AnalyzedMesh& target, const std::vector<SegmentLoop>& loops,
  const DenseMap& map, const std::vector<int>& pieceOfTargetTriangle,
  std::vector<BoundaryPair>& pairs)
{
  std::vector<Eigen::Vector3d> carried;
  for (const SourceSearch::Query& place : map.Places)
  {
    carried.push_back(place.Position);
  }
  // The target's pieces are labelled with the source's, so a loop there says which two it parts.
  const SegmentPieces targetPieces = FindPieces(target.Mesh, pieceOfTargetTriangle);
  const std::vector<SegmentLoop> targetLoops = FindLoops(target.Mesh, targetPieces);
  std::vector<bool> isTaken(targetLoops.size(), false);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const Eigen::Vector3d center = Mean(pairs[i].SourcePoints);
    double least = std::numeric_limits<double>::infinity();
    int best = -1;
    bool reversed = false;
    for (std::size_t j = 0; j < targetLoops.size(); ++j)
    {
      const int left = targetPieces.LabelOfPiece[targetLoops[j].LeftPiece];
      const int right = targetPieces.LabelOfPiece[targetLoops[j].RightPiece];
      const bool same = left == loops[i].LeftPiece && right == loops[i].RightPiece;
      const bool other = left == loops[i].RightPiece && right == loops[i].LeftPiece;
      if (isTaken[j] || (!same && !other))
      {
        continue;
      }
      const double distance =
        (Mean(Gather(carried, targetLoops[j].Vertices(target.Mesh))) - center).norm();
      if (distance < least)
      {
        least = distance;
        best = static_cast<int>(j);
        reversed = other;
      }
    }
    if (best < 0)
    {
      continue;
    }
    isTaken[best] = true;
    std::vector<int> vertices = targetLoops[best].Vertices(target.Mesh);
    if (reversed)
    {
      std::reverse(vertices.begin(), vertices.end());
    }
    pairs[i].TargetPoints = Correspond(
      pairs[i].SourcePoints, Gather(target.Mesh.Points, vertices), Gather(carried, vertices));
  }
}
}
