// SPDX-License-Identifier: BSD-3-Clause
#include "RegionMatch.h"

#include <algorithm>
#include <map>
#include <utility>

namespace marrow
{
namespace
{
/// Numbers the parts of a surface that are connected without crossing a cut.
std::vector<int> FloodRegions(
  const TriangleMesh& mesh, const std::vector<bool>& isCut, int& numberOfRegions)
{
  std::vector<int> region(mesh.NumberOfTriangles(), -1);
  numberOfRegions = 0;
  std::vector<int> stack;
  for (int first = 0; first < mesh.NumberOfTriangles(); ++first)
  {
    if (region[first] >= 0)
    {
      continue;
    }
    region[first] = numberOfRegions;
    stack.assign(1, first);
    while (!stack.empty())
    {
      const int triangle = stack.back();
      stack.pop_back();
      for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
      {
        const int opposite = mesh.Opposite[h];
        const int next = opposite < 0 ? -1 : TriangleMesh::TriangleOf(opposite);
        if (next >= 0 && !isCut[h] && region[next] < 0)
        {
          region[next] = numberOfRegions;
          stack.push_back(next);
        }
      }
    }
    ++numberOfRegions;
  }
  return region;
}

/// The half-edges of the target along a cut, each in the triangle before the curve.
std::vector<int> HalfEdgesOfCut(const TriangleMesh& mesh, const BoundaryTransfer::Cut& cut)
{
  std::vector<char> side(mesh.NumberOfTriangles(), -1);
  for (const auto& [triangle, value] : cut.Sides)
  {
    side[triangle] = value;
  }
  std::vector<int> halfEdges;
  for (const auto& [triangle, value] : cut.Sides)
  {
    for (int h = 3 * triangle; value == 0 && h < 3 * triangle + 3; ++h)
    {
      const int opposite = mesh.Opposite[h];
      if (opposite >= 0 && side[TriangleMesh::TriangleOf(opposite)] == 1)
      {
        halfEdges.push_back(h);
      }
    }
  }
  return halfEdges;
}

void MarkCut(const TriangleMesh& mesh, const std::vector<int>& halfEdges, std::vector<bool>& isCut)
{
  for (int h : halfEdges)
  {
    isCut[h] = true;
    isCut[mesh.Opposite[h]] = true;
  }
}

/// The regions that are left if only these half-edges are cut.
std::vector<int> RegionsOfCut(const TriangleMesh& mesh, const std::vector<int>& halfEdges)
{
  std::vector<bool> isCut(mesh.Opposite.size(), false);
  MarkCut(mesh, halfEdges, isCut);
  int numberOfRegions = 0;
  return FloodRegions(mesh, isCut, numberOfRegions);
}

bool PartsLandmarksAlike(const TriangleMesh& source, const std::vector<int>& sourceHalfEdges,
  const TriangleMesh& target, const std::vector<int>& targetHalfEdges,
  const std::vector<TrianglePair>& landmarks)
{
  if (landmarks.empty())
  {
    return true;
  }
  const std::vector<int> sourceRegion = RegionsOfCut(source, sourceHalfEdges);
  const std::vector<int> targetRegion = RegionsOfCut(target, targetHalfEdges);
  const TrianglePair& first = landmarks.front();
  return std::all_of(landmarks.begin(), landmarks.end(),
    [&](const TrianglePair& other)
    {
      return (sourceRegion[other.first] == sourceRegion[first.first]) ==
        (targetRegion[other.second] == targetRegion[first.second]);
    });
}

/// How many half-edges along one side of one loop join a target region with a source region.
struct Vote
{
  int Cut;
  int TargetRegion;
  int SourceRegion;
  int Count;
};
}

RegionMatch MatchRegions(const TriangleMesh& source, const TriangleMesh& target,
  const std::vector<SegmentLoop>& loops, const std::vector<TrianglePair>& landmarks,
  std::vector<LoopCut>& cuts)
{
  cuts.erase(std::remove_if(cuts.begin(), cuts.end(),
               [&](const LoopCut& cut)
               {
                 return !PartsLandmarksAlike(source, loops[cut.Loop].HalfEdges, target,
                   HalfEdgesOfCut(target, cut.Cut), landmarks);
               }),
    cuts.end());
  for (;;)
  {
    RegionMatch match;
    std::vector<bool> sourceCut(source.Opposite.size(), false);
    std::vector<bool> targetCut(target.Opposite.size(), false);
    std::vector<std::vector<int>> targetHalfEdges;
    for (const LoopCut& cut : cuts)
    {
      MarkCut(source, loops[cut.Loop].HalfEdges, sourceCut);
      targetHalfEdges.push_back(HalfEdgesOfCut(target, cut.Cut));
      MarkCut(target, targetHalfEdges.back(), targetCut);
    }
    int sourceRegions = 0;
    int targetRegions = 0;
    match.SourceRegionOfTriangle = FloodRegions(source, sourceCut, sourceRegions);
    match.RegionOfTriangle = FloodRegions(target, targetCut, targetRegions);

    std::vector<Vote> votes;
    for (std::size_t c = 0; c < cuts.size(); ++c)
    {
      const std::vector<int>& loop = loops[cuts[c].Loop].HalfEdges;
      for (int side = 0; side < 2; ++side)
      {
        // The source's region on this side: of the most half-edges of the loop.
        std::map<int, int> counts;
        for (int h : loop)
        {
          const bool left = (side == 0) == cuts[c].Cut.LeftIsFront;
          const int triangle = TriangleMesh::TriangleOf(left ? h : source.Opposite[h]);
          ++counts[match.SourceRegionOfTriangle[triangle]];
        }
        const int sourceRegion = std::max_element(counts.begin(), counts.end(),
          [](const auto& a, const auto& b) {
            return a.second < b.second;
          })->first;
        std::map<int, int> targets;
        for (int h : targetHalfEdges[c])
        {
          const int triangle = TriangleMesh::TriangleOf(side == 0 ? h : target.Opposite[h]);
          ++targets[match.RegionOfTriangle[triangle]];
        }
        for (const auto& [region, count] : targets)
        {
          votes.push_back({ static_cast<int>(c), region, sourceRegion, count });
        }
      }
    }

    // Each target region goes where most of its borders say.
    std::vector<std::map<int, int>> sums(targetRegions);
    for (const Vote& vote : votes)
    {
      sums[vote.TargetRegion][vote.SourceRegion] += vote.Count;
    }
    match.SourceRegion.assign(targetRegions, targetRegions == 1 ? 0 : -1);
    for (int r = 0; r < targetRegions; ++r)
    {
      if (!sums[r].empty())
      {
        match.SourceRegion[r] = std::max_element(sums[r].begin(), sums[r].end(),
          [](const auto& a, const auto& b) {
            return a.second < b.second;
          })->first;
      }
    }
    // A loop is wrong by the share of its border that lies between other regions than on the source.
    double worst = 0.0;
    std::size_t worstCut = 0;
    std::vector<double> wrong(cuts.size(), 0.0);
    std::vector<double> total(cuts.size(), 0.0);
    for (const Vote& vote : votes)
    {
      total[vote.Cut] += vote.Count;
      wrong[vote.Cut] +=
        match.SourceRegion[vote.TargetRegion] != vote.SourceRegion ? vote.Count : 0;
    }
    for (std::size_t c = 0; c < cuts.size(); ++c)
    {
      const double share = total[c] > 0.0 ? wrong[c] / total[c] : 1.0;
      if (share > worst)
      {
        worst = share;
        worstCut = c;
      }
    }
    constexpr double tolerable = 0.1;
    if (worst <= tolerable)
    {
      return match;
    }
    cuts.erase(cuts.begin() + static_cast<std::ptrdiff_t>(worstCut));
  }
}
}
