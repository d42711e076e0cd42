// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerChoice.h"

#include "CoarseMesh.h"
#include "DenseMap.h"
#include "LeftoverPlaces.h"
#include "SkeletonMap.h"
#include "WholeAlignment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace marrow
{
namespace
{
/// Smaller differences of the sum are noise of the coarse map: where only these speak for another
/// answer, the skeletons decide. Anything from 0.01 to 0.02 does.
constexpr double Margin = 0.015;

std::vector<SkeletonMap::Place> PlacesOf(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const MatchedSkeletons& match)
{
  SkeletonMap map(source, target, match);
  for (std::size_t c = 0; c < match.Chains.size(); ++c)
  {
    const ChainPair& chain = match.Chains[c];
    map.SetAlignment(
      static_cast<int>(c), AlignChains(source, chain.Source, target, chain.Target, {}));
  }
  std::vector<SkeletonMap::Place> places = map.PlacesOfTargetNodes();
  std::vector<bool> isMatched = map.MatchedSourceNodes();
  PlaceLeftovers(source, target, places, isMatched);
  return places;
}

/// The value below and above which half of the weights lie.
double WeightedMedian(std::vector<std::pair<double, double>> values)
{
  std::sort(values.begin(), values.end());
  double total = 0.0;
  for (const auto& entry : values)
  {
    total += entry.second;
  }
  double below = 0.0;
  for (const auto& [value, weight] : values)
  {
    below += weight;
    if (2.0 * below >= total)
    {
      return value;
    }
  }
  return 0.0;
}

MatchedSkeletons Reversed(const MatchedSkeletons& match)
{
  MatchedSkeletons reversed = match;
  for (ChainPair& chain : reversed.Chains)
  {
    std::swap(chain.Source, chain.Target);
  }
  std::swap(reversed.Ids.SourceNodes, reversed.Ids.TargetNodes);
  std::swap(reversed.Ids.SourceBranches, reversed.Ids.TargetBranches);
  std::swap(reversed.Ids.SourceOrder, reversed.Ids.TargetOrder);
  return reversed;
}

/// Adds half of what speaks against `map`, which carries `target` to `source`.
void AddHalf(
  const CoarseMesh& source, const CoarseMesh& target, const DenseMap& map, Evidence& evidence)
{
  const std::vector<Eigen::Vector3d> sourceNormals = source.Side.Mesh.VertexNormals();
  std::vector<double> surplus(source.NumberOfPatches, 0.0);
  for (std::size_t v = 0; v < source.Patches.size(); ++v)
  {
    surplus[source.Patches[v]] -= source.Shares[v];
  }
  constexpr double least = 1e-9;
  // The log of MSP here over MSP there, with the share of the area.
  std::vector<std::pair<double, double>> ratios;
  for (std::size_t v = 0; v < target.Shares.size(); ++v)
  {
    double there = 0.0;
    double cosine = 0.0;
    for (const int corner : source.Side.Mesh.Triangles[map.FoundTriangles[v]])
    {
      there += source.Side.MSP[corner] / 3.0;
      cosine += map.Places[v].Normal.dot(sourceNormals[corner]) / 3.0;
      surplus[source.Patches[corner]] += target.Shares[v] / 3.0;
    }
    ratios.emplace_back(std::log(std::max(target.Side.MSP[v] / target.Size, least) /
                          std::max(there / source.Size, least)),
      target.Shares[v]);
    evidence.Turned += 0.5 * target.Shares[v] * (1.0 - cosine);
  }
  const double usual = WeightedMedian(ratios);
  for (const auto& [ratio, share] : ratios)
  {
    evidence.Thickness += 0.5 * share * std::min(std::abs(ratio - usual), 1.0);
  }
  for (const double value : surplus)
  {
    evidence.Cover += 0.5 * 0.5 * std::abs(value);
  }
}

/// One of two coarse meshes that are mapped to each other.
struct Direction
{
  const CoarseMesh& Source;
  const CoarseMesh& Target;
  DenseMapper Mapper;

  Direction(const CoarseMesh& source, const CoarseMesh& target)
    : Source(source)
    , Target(target)
    , Mapper(source.Side, target.Side, {}, AlignWhole(source.Side.Mesh, target.Side.Mesh))
  {
  }

  void AddHalf(const MatchedSkeletons& match, Evidence& evidence) const
  {
    const DenseMap map =
      this->Mapper.Map(PlacesOf(this->Source.Side, this->Target.Side, match), !match.IsEmpty(), {});
    marrow::AddHalf(this->Source, this->Target, map, evidence);
  }
};
}

std::size_t ChooseAnswer(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<Answer>& answers, const Progress& progress)
{
  if (answers.size() < 2)
  {
    return 0;
  }
  const CoarseMesh coarseSource = Coarsen(source);
  const CoarseMesh coarseTarget = Coarsen(target);
  if (coarseSource.Side.Mesh.Triangles.empty() || coarseTarget.Side.Mesh.Triangles.empty())
  {
    return 0;
  }
  const Direction there(coarseSource, coarseTarget);
  const Direction back(coarseTarget, coarseSource);
  std::size_t best = 0;
  double least = 0.0;
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    if (!Report(progress, static_cast<double>(i) / answers.size()))
    {
      return best;
    }
    const MatchedSkeletons& match = answers[i].Match;
    Evidence evidence;
    evidence.Cost = match.IsEmpty() ? 1.0 : answers[i].Cost;
    there.AddHalf(match, evidence);
    back.AddHalf(Reversed(match), evidence);
    const double against = evidence.Sum();
    if (i == 0 || against < least - (best == 0 ? Margin : 0.0))
    {
      least = against;
      best = i;
    }
  }
  return best;
}
}
