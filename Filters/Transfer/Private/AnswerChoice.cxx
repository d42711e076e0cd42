// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerChoice.h"

#include "AnswerPlaces.h"
#include "AnswerSearch.h"
#include "SkeletonMap.h"

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

/// What speaks against `map`, which carries `target` to `source`.
Evidence Judge(
  const CoarseMesh& source, const CoarseMesh& target, const Answer& answer, const DenseMap& map)
{
  Evidence evidence;
  evidence.Cost = answer.CostOfMatch();
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
    evidence.Turned += target.Shares[v] * (1.0 - cosine);
  }
  const double usual = WeightedMedian(ratios);
  for (const auto& [ratio, share] : ratios)
  {
    evidence.Thickness += share * std::min(std::abs(ratio - usual), 1.0);
  }
  for (const double value : surplus)
  {
    evidence.Cover += 0.5 * std::abs(value);
  }
  return evidence;
}
}

AnswerTrial TryAnswer(
  const CoarseMesh& source, const CoarseMesh& target, DenseMapper& mapper, const Answer& answer)
{
  SkeletonMap skeletonMap(source.Side, target.Side, answer.Match);
  AlignByProfiles(source.Side, target.Side, answer.Match, skeletonMap);
  DenseMap map =
    mapper.Map(PlacesByMap(source.Side, target.Side, skeletonMap), !answer.Match.IsEmpty(), {});
  AnswerTrial trial;
  trial.Against = Judge(source, target, answer, map);
  trial.FoundTriangles = std::move(map.FoundTriangles);
  trial.IsWholeAlignment = map.IsWholeAlignment;
  return trial;
}

std::size_t LikeliestAnswer(const std::vector<double>& against)
{
  std::size_t best = 0;
  for (std::size_t i = 1; i < against.size(); ++i)
  {
    if (against[i] < against[best] - (best == 0 ? Margin : 0.0))
    {
      best = i;
    }
  }
  return best;
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
  DenseMapper there(coarseSource.Side, coarseTarget.Side, {});
  DenseMapper back(coarseTarget.Side, coarseSource.Side, {});
  std::vector<double> against;
  for (const Answer& answer : answers)
  {
    if (!Report(progress, static_cast<double>(against.size()) / answers.size()))
    {
      return 0;
    }
    against.push_back(0.5 * TryAnswer(coarseSource, coarseTarget, there, answer).Against.Sum() +
      0.5 * TryAnswer(coarseTarget, coarseSource, back, Turned(answer)).Against.Sum());
  }
  return LikeliestAnswer(against);
}
}
