// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentationTransfer.h"

#include "BoundaryPairs.h"
#include "BoundaryPlacement.h"
#include "BoundaryTransfer.h"
#include "GhostBoundary.h"
#include "GuidedMap.h"
#include "InteriorLabels.h"
#include "LabelCleanUp.h"
#include "LeftoverPlaces.h"
#include "RegionMatch.h"
#include "SegmentLoops.h"
#include "SkeletonMap.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace marrow
{
namespace
{
void SetAlignments(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, const TransferParameters& parameters, SkeletonMap& map)
{
  for (std::size_t c = 0; c < match.Chains.size(); ++c)
  {
    const Branch& sourceChain = match.Chains[c].Source;
    const Branch& targetChain = match.Chains[c].Target;
    const auto landmark = MatchGhostBoundaries(
      FindGhostBoundaries(source, sourceChain, parameters.Theta, parameters.Kernel),
      FindGhostBoundaries(target, targetChain, parameters.Theta, parameters.Kernel));
    map.SetAlignment(
      static_cast<int>(c), AlignChains(source, sourceChain, target, targetChain, landmark));
  }
}

/// Pieces that lie for the most part on matched branches, or hold a part of what is matched: a matched
/// node whose φ lies for the most part in them. (A patch on a limb holds no node; a body is one even
/// if most of its surface belongs to a branch of its own that has no partner.)
std::vector<bool> TransferredPieces(const AnalyzedMesh& source, const SegmentPieces& pieces,
  const std::vector<bool>& isMatched, bool anyMatched)
{
  if (!anyMatched)
  {
    return std::vector<bool>(pieces.NumberOfPieces(), true);
  }
  std::vector<std::map<int, double>> areaInPieces(isMatched.size());
  std::vector<double> matched(pieces.NumberOfPieces(), 0.0);
  for (int t = 0; t < source.Mesh.NumberOfTriangles(); ++t)
  {
    const double third = source.Mesh.Area(t) / 3.0;
    for (int corner : source.Mesh.Triangles[t])
    {
      const int node = source.NodeOfVertex[corner];
      if (node >= 0 && isMatched[node])
      {
        areaInPieces[node][pieces.PieceOfTriangle[t]] += third;
        matched[pieces.PieceOfTriangle[t]] += third;
      }
    }
  }
  std::vector<bool> result(pieces.NumberOfPieces());
  for (int p = 0; p < pieces.NumberOfPieces(); ++p)
  {
    result[p] = matched[p] >= 0.5 * pieces.AreaOfPiece[p];
  }
  for (const auto& shares : areaInPieces)
  {
    if (!shares.empty())
    {
      const auto most = std::max_element(shares.begin(), shares.end(),
        [](const auto& x, const auto& y) { return x.second < y.second; });
      result[most->first] = true;
    }
  }
  // If no piece qualifies there is nothing better than to try them all.
  return std::count(result.begin(), result.end(), true) > 0
    ? result
    : std::vector<bool>(pieces.NumberOfPieces(), true);
}

/// A triangle at either tip of every matched pair of limbs.
std::vector<TrianglePair> TipsOfMatchedLimbs(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const MatchedSkeletons& match)
{
  const auto triangleAt = [](const AnalyzedMesh& side, int node)
  {
    const std::vector<int>& vertices = side.Skeleton.Graph[node].Vertices;
    const int h = vertices.empty() ? -1 : side.Mesh.Outgoing[vertices.front()];
    return side.Skeleton.TypeOf(node) == NodeType::Terminal && h >= 0 ? TriangleMesh::TriangleOf(h)
                                                                      : -1;
  };
  std::vector<TrianglePair> tips;
  for (const ChainPair& chain : match.Chains)
  {
    for (const bool back : { false, true })
    {
      const int s = triangleAt(source, back ? chain.Source.Back() : chain.Source.Front());
      const int t = triangleAt(target, back ? chain.Target.Back() : chain.Target.Front());
      if (s >= 0 && t >= 0)
      {
        tips.emplace_back(s, t);
      }
    }
  }
  return tips;
}

/// What each region of the target may be: the pieces of its partner on the source.
AllowedPieces PiecesOfRegions(const SegmentPieces& pieces, const RegionMatch& match,
  const std::vector<bool>& isTransferred, bool largestOnly)
{
  std::vector<std::set<int>> ofSourceRegion;
  for (std::size_t t = 0; t < match.SourceRegionOfTriangle.size(); ++t)
  {
    const int piece = pieces.PieceOfTriangle[t];
    const std::size_t region = static_cast<std::size_t>(match.SourceRegionOfTriangle[t]);
    if (isTransferred[piece])
    {
      ofSourceRegion.resize(std::max(ofSourceRegion.size(), region + 1));
      ofSourceRegion[region].insert(piece);
    }
  }
  AllowedPieces allowed;
  for (int region : match.SourceRegion)
  {
    allowed.emplace_back();
    if (region >= 0 && region < static_cast<int>(ofSourceRegion.size()))
    {
      allowed.back().assign(ofSourceRegion[region].begin(), ofSourceRegion[region].end());
    }
    if (largestOnly && allowed.back().size() > 1)
    {
      allowed.back().assign(1,
        *std::max_element(allowed.back().begin(), allowed.back().end(),
          [&](int a, int b) { return pieces.AreaOfPiece[a] < pieces.AreaOfPiece[b]; }));
    }
  }
  return allowed;
}

double ShareOf(const AnalyzedMesh& target, const GuidedMap& map, int triangle, int piece)
{
  const auto& corners = target.Mesh.Triangles[triangle];
  return (map.Shares(corners[0], piece) + map.Shares(corners[1], piece) +
           map.Shares(corners[2], piece)) /
    3.0;
}

/// A piece so small that the cut lost it gets the triangles where the map sees it best, but never
/// more than half of what another piece has.
void RestoreLostPieces(const AnalyzedMesh& target, const GuidedMap& map,
  const std::vector<bool>& isTransferred, std::vector<int>& pieceOfTriangle)
{
  const int n = static_cast<int>(pieceOfTriangle.size());
  std::vector<int> count(isTransferred.size(), 0);
  for (int piece : pieceOfTriangle)
  {
    ++count[piece];
  }
  for (int piece = 0; piece < static_cast<int>(isTransferred.size()); ++piece)
  {
    if (!isTransferred[piece] || count[piece] > 0)
    {
      continue;
    }
    double largest = 0.0;
    for (int t = 0; t < n; ++t)
    {
      largest = std::max(largest, ShareOf(target, map, t, piece));
    }
    constexpr double leastShare = 0.1;
    if (largest < leastShare)
    {
      continue;
    }
    std::vector<int> left = count;
    for (int t = 0; t < n; ++t)
    {
      int& current = pieceOfTriangle[t];
      if (ShareOf(target, map, t, piece) >= 0.5 * largest &&
        2 * (left[current] - 1) >= count[current])
      {
        --left[current];
        ++left[piece];
        current = piece;
      }
    }
    count = left;
  }
}

void SetConfidence(const AnalyzedMesh& target, const GuidedMap& map, const SegmentPieces& pieces,
  double correspondenceConfidence, TransferResult& result)
{
  // An alignment as wholes knows nothing of parts.
  const double trust = correspondenceConfidence * (map.IsWholeAlignment ? 0.5 : 1.0);
  result.Confidence.resize(result.Labels.size());
  for (std::size_t t = 0; t < result.Labels.size(); ++t)
  {
    double share = 0.0;
    for (int piece = 0; piece < pieces.NumberOfPieces(); ++piece)
    {
      if (pieces.LabelOfPiece[piece] == result.Labels[t])
      {
        share += ShareOf(target, map, static_cast<int>(t), piece);
      }
    }
    double certainty = 0.0;
    for (int corner : target.Mesh.Triangles[t])
    {
      certainty += map.Certainty[corner] / 3.0;
    }
    result.Confidence[t] =
      std::clamp(trust * (0.5 + 0.5 * certainty) * std::clamp(share, 0.0, 1.0), 0.0, 1.0);
  }
}

void SetMissing(
  const SegmentPieces& pieces, const std::vector<int>& pieceOfTriangle, TransferResult& result)
{
  const std::set<int> present(pieceOfTriangle.begin(), pieceOfTriangle.end());
  std::set<int> missing(pieces.LabelOfPiece.begin(), pieces.LabelOfPiece.end());
  for (int piece : present)
  {
    missing.erase(pieces.LabelOfPiece[piece]);
  }
  result.MissingLabels.assign(missing.begin(), missing.end());
  result.NumberOfMissingPieces = pieces.NumberOfPieces() - static_cast<int>(present.size());
}
}

TransferResult TransferSegmentation(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, double correspondenceConfidence, const std::vector<int>& labels,
  const TransferParameters& parameters, const Progress& progress)
{
  TransferResult result;
  // Once told to stop, nobody is asked again.
  const Progress watched = [&](double fraction)
  {
    result.IsAborted = result.IsAborted || !Report(progress, fraction);
    return !result.IsAborted;
  };
  const SegmentPieces pieces = FindPieces(source.Mesh, labels);
  const std::vector<SegmentLoop> loops = FindLoops(source.Mesh, pieces);
  SkeletonMap map(source, target, match);
  SetAlignments(source, target, match, parameters, map);
  const bool anyMatched = !match.IsEmpty();
  std::vector<SkeletonMap::Place> places = map.PlacesOfTargetNodes();
  std::vector<bool> isMatched = map.MatchedSourceNodes();
  PlaceLeftovers(source, target, places, isMatched);
  const std::vector<bool> isTransferred = TransferredPieces(source, pieces, isMatched, anyMatched);
  if (!watched(0.1))
  {
    return result;
  }

  const GuidedMap guided = BuildGuidedMap(
    source, target, places, anyMatched, pieces, isTransferred, SubProgress(watched, 0.1, 0.5));
  if (!watched(0.5))
  {
    return result;
  }

  result.IsWholeAlignment = guided.IsWholeAlignment;

  std::vector<LoopCut> cuts;
  BoundaryTransfer transfer(
    source, target, match, map, { parameters.Lambda, parameters.SearchRegion });
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (!watched(0.5 + 0.2 * i / loops.size()))
    {
      return result;
    }
    if (!isTransferred[loops[i].LeftPiece] || !isTransferred[loops[i].RightPiece])
    {
      continue;
    }
    const auto seat = transfer.FindSeat(loops[i]);
    if (!seat)
    {
      continue;
    }
    // Of the two ways to bring the loop over, the one that agrees better with the map; if neither
    // does, the map alone decides.
    constexpr double mostDisagreement = 0.3;
    double least = mostDisagreement;
    std::optional<BoundaryTransfer::Cut> best;
    const auto consider = [&](std::optional<BoundaryTransfer::Cut> cut)
    {
      const double disagreement =
        cut ? Disagreement(source, target, loops[i], *cut, pieces, guided) : 1.0;
      if (disagreement < least)
      {
        least = disagreement;
        best = std::move(cut);
      }
    };
    consider(transfer.TransferByFrame(loops[i], *seat, map.TargetRatio(seat->Chain, seat->Ratio)));
    consider(transfer.TransferByMap(loops[i], *seat, guided.Positions, guided.FoundPoints));
    if (best)
    {
      cuts.push_back({ static_cast<int>(i), std::move(*best) });
    }
  }
  const RegionMatch regions =
    MatchRegions(source.Mesh, target.Mesh, loops, TipsOfMatchedLimbs(source, target, match), cuts);
  const AllowedPieces allowed =
    PiecesOfRegions(pieces, regions, isTransferred, parameters.StrictBoundaries);
  std::vector<int> pieceOfTriangle = LabelInterior(
    target, guided, regions.RegionOfTriangle, allowed, SubProgress(watched, 0.7, 0.9));
  if (!watched(0.9))
  {
    return result;
  }
  KeepLargestComponents(target.Mesh, pieceOfTriangle);
  if (!parameters.StrictBoundaries)
  {
    RestoreLostPieces(target, guided, isTransferred, pieceOfTriangle);
    KeepLargestComponents(target.Mesh, pieceOfTriangle);
  }

  result.Labels.reserve(pieceOfTriangle.size());
  for (int piece : pieceOfTriangle)
  {
    result.Labels.push_back(pieces.LabelOfPiece[piece]);
  }
  SetConfidence(target, guided, pieces, correspondenceConfidence, result);
  SetMissing(pieces, pieceOfTriangle, result);
  result.Boundaries = PairBoundaries(source, target, pieces, loops, cuts, guided, pieceOfTriangle);
  watched(1.0);
  return result;
}
}
