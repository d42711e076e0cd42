// SPDX-License-Identifier: BSD-3-Clause
#include "LeftoverPlaces.h"

#include "BestRotation.h"

#include <Eigen/SVD>

#include <algorithm>
#include <optional>

namespace marrow
{
namespace
{
/// How near counts as the same place, of the source's diagonal.
constexpr double Reach = 0.15;
/// Matched nodes nearer to a part than this, of the target's diagonal, count about alike.
constexpr double Focus = 0.1;

/// The connected parts of the target's skeleton that have no partner.
std::vector<std::vector<int>> FindLeftovers(
  const Skeleton& skeleton, const std::vector<SkeletonMap::Place>& places)
{
  std::vector<std::vector<int>> parts;
  std::vector<bool> seen(places.size(), false);
  for (std::size_t start = 0; start < places.size(); ++start)
  {
    if (seen[start] || places[start].Matched)
    {
      continue;
    }
    std::vector<int> part{ static_cast<int>(start) };
    seen[start] = true;
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      for (auto [e, end] = boost::out_edges(part[i], skeleton.Graph); e != end; ++e)
      {
        const int next = static_cast<int>(boost::target(*e, skeleton.Graph));
        if (!seen[next] && !places[next].Matched)
        {
          seen[next] = true;
          part.push_back(next);
        }
      }
    }
    parts.push_back(part);
  }
  return parts;
}

/// The similarity that carries the matched target nodes to their places, weighted by nearness to
/// `center`; nothing if they are too few or on one line, so that it could turn about that.
std::optional<Eigen::Matrix<double, 3, 4>> FitSimilarity(const AnalyzedMesh& target,
  const std::vector<SkeletonMap::Place>& places, const Eigen::Vector3d& center)
{
  const double focus = std::max(Focus * target.Diagonal(), 1e-300);
  Eigen::Vector3d sourceMean = Eigen::Vector3d::Zero();
  Eigen::Vector3d targetMean = Eigen::Vector3d::Zero();
  double total = 0.0;
  const auto forEachMatched = [&](const auto& visit)
  {
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      if (places[n].Matched)
      {
        const Eigen::Vector3d& t = target.Skeleton.Graph[n].Position;
        const Eigen::Vector3d s =
          places[n].Transform.leftCols<3>() * t + places[n].Transform.col(3);
        visit(1.0 / ((t - center).squaredNorm() / (focus * focus) + 1.0), s, t);
      }
    }
  };
  forEachMatched(
    [&](double weight, const Eigen::Vector3d& s, const Eigen::Vector3d& t)
    {
      sourceMean += weight * s;
      targetMean += weight * t;
      total += weight;
    });
  if (total <= 0.0)
  {
    return std::nullopt;
  }
  sourceMean /= total;
  targetMean /= total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double targetSpread = 0.0;
  forEachMatched(
    [&](double weight, const Eigen::Vector3d& s, const Eigen::Vector3d& t)
    {
      covariance += weight / total * (s - sourceMean) * (t - targetMean).transpose();
      targetSpread += weight / total * (t - targetMean).squaredNorm();
    });
  const Eigen::Vector3d breadths = covariance.jacobiSvd().singularValues();
  constexpr double leastBreadth =
    0.01; // of the length: less is a line, about which anything may turn
  if (!(breadths[1] > leastBreadth * breadths[0]))
  {
    return std::nullopt;
  }
  const Eigen::Matrix3d rotation = BestRotation(covariance);
  const double scale = rotation.cwiseProduct(covariance).sum() / targetSpread;
  Eigen::Matrix<double, 3, 4> result;
  result.leftCols<3>() = scale * rotation;
  result.col(3) = sourceMean - scale * rotation * targetMean;
  return result;
}
}

void PlaceLeftovers(const AnalyzedMesh& source, const AnalyzedMesh& target,
  std::vector<SkeletonMap::Place>& places, std::vector<bool>& isMatched)
{
  const double reach = Reach * source.Diagonal();
  const std::vector<bool> wasMatched = isMatched;
  for (const std::vector<int>& part : FindLeftovers(target.Skeleton, places))
  {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (int node : part)
    {
      center += target.Skeleton.Graph[node].Position / static_cast<double>(part.size());
    }
    const auto similarity = FitSimilarity(target, places, center);
    if (!similarity)
    {
      continue;
    }
    for (int node : part)
    {
      const Eigen::Vector3d carried =
        similarity->leftCols<3>() * target.Skeleton.Graph[node].Position + similarity->col(3);
      int nearest = -1;
      double least = reach;
      for (int s = 0; s < source.Skeleton.NumberOfNodes(); ++s)
      {
        const double distance = (source.Skeleton.Graph[s].Position - carried).norm();
        if (!wasMatched[s] && distance < least)
        {
          least = distance;
          nearest = s;
        }
      }
      if (nearest >= 0)
      {
        SkeletonMap::Place& place = places[node];
        place.Known = true;
        place.IsLeftover = true;
        place.SourceNode = nearest;
        place.Radius = source.Skeleton.Graph[nearest].Radius;
        place.Transform = *similarity;
        isMatched[nearest] = true;
      }
    }
  }
}
}
