// SPDX-License-Identifier: BSD-3-Clause
#include "GhostBoundary.h"

#include "MinimumCut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marrow
{
namespace
{
/// Of the profile of a branch: one for each half percent.
constexpr int NumberOfSamples = 201;

/// The lowest value from k on in one direction, until the profile rises above its value at k.
double FlankMinimum(const std::vector<double>& profile, int k, int step)
{
  double least = profile[k];
  for (int j = k + step; j >= 0 && j < NumberOfSamples && profile[j] <= profile[k]; j += step)
  {
    least = std::min(least, profile[j]);
  }
  return least;
}

std::vector<double> FindPeaks(const std::vector<double>& profile, double theta)
{
  std::vector<double> peaks;
  for (int k = 1; k + 1 < NumberOfSamples; ++k)
  {
    if (profile[k] > profile[k - 1] && profile[k] >= profile[k + 1] &&
      profile[k] >= theta * std::max(FlankMinimum(profile, k, -1), FlankMinimum(profile, k, 1)))
    {
      peaks.push_back(static_cast<double>(k) / (NumberOfSamples - 1));
    }
  }
  return peaks;
}

/// The ratio along the chain of every vertex of it, -1 for all others: where its projection to the
/// chain falls, near its own node.
std::vector<double> RatioOfVertices(const AnalyzedMesh& side, const Branch& chain)
{
  std::vector<double> ratios(side.Mesh.NumberOfVertices(), -1.0);
  const int last = static_cast<int>(chain.Nodes.size()) - 1;
  for (int i = 0; i <= last; ++i)
  {
    for (int v : side.Skeleton.Graph[chain.Nodes[i]].Vertices)
    {
      double best = std::numeric_limits<double>::infinity();
      for (int j = std::max(i - 1, 0); j < std::min(i + 1, last); ++j)
      {
        const Eigen::Vector3d& p = side.Skeleton.Graph[chain.Nodes[j]].Position;
        const Eigen::Vector3d d = side.Skeleton.Graph[chain.Nodes[j + 1]].Position - p;
        const double squared = d.squaredNorm();
        const double t =
          squared > 0.0 ? std::clamp((side.Mesh.Points[v] - p).dot(d) / squared, 0.0, 1.0) : 0.0;
        const double distance = (side.Mesh.Points[v] - p - t * d).norm();
        if (distance < best)
        {
          best = distance;
          ratios[v] = (chain.ArcLength[j] + t * (chain.ArcLength[j + 1] - chain.ArcLength[j])) /
            chain.Length();
        }
      }
    }
  }
  return ratios;
}

/// Cuts the fuzzy region round a peak; false if the region has no two ends to cut between.
bool CutFuzzyRegion(const AnalyzedMesh& side, const std::vector<double>& ratios, double peak,
  double halfWidth, double largest, GhostBoundary& ghost)
{
  const TriangleMesh& mesh = side.Mesh;
  std::vector<int> triangles;
  std::vector<int> nodeOfTriangle(mesh.NumberOfTriangles(), -1);
  std::vector<double> ratioOfTriangle;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto& corners = mesh.Triangles[t];
    if (ratios[corners[0]] < 0.0 || ratios[corners[1]] < 0.0 || ratios[corners[2]] < 0.0)
    {
      continue;
    }
    const double ratio = (ratios[corners[0]] + ratios[corners[1]] + ratios[corners[2]]) / 3.0;
    if (std::abs(ratio - peak) > 1.5 * halfWidth)
    {
      continue;
    }
    nodeOfTriangle[t] = static_cast<int>(triangles.size());
    triangles.push_back(t);
    ratioOfTriangle.push_back(ratio);
  }
  MinimumCut cut(static_cast<int>(triangles.size()));
  bool hasFront = false;
  bool hasBack = false;
  constexpr double uncuttable = 1e12; // more than all capacities together
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const int node = static_cast<int>(i);
    if (ratioOfTriangle[i] < peak - halfWidth)
    {
      cut.AddTerminal(node, uncuttable, 0.0);
      hasFront = true;
    }
    else if (ratioOfTriangle[i] > peak + halfWidth)
    {
      cut.AddTerminal(node, 0.0, uncuttable);
      hasBack = true;
    }
  }
  if (!hasFront || !hasBack)
  {
    return false;
  }
  const auto gradient = [&](int h)
  { return 0.5 * (side.GradientMagnitude[mesh.From(h)] + side.GradientMagnitude[mesh.To(h)]); };
  std::vector<int> edges;
  for (int t : triangles)
  {
    for (int h = 3 * t; h < 3 * t + 3; ++h)
    {
      const int opposite = mesh.Opposite[h];
      if (opposite <= h || nodeOfTriangle[TriangleMesh::TriangleOf(opposite)] < 0)
      {
        continue;
      }
      const double length = (mesh.Points[mesh.From(h)] - mesh.Points[mesh.To(h)]).norm();
      constexpr double epsilon = 0.001; // the paper's
      const double capacity = length / side.Diagonal() / (gradient(h) + epsilon);
      cut.AddEdge(
        nodeOfTriangle[t], nodeOfTriangle[TriangleMesh::TriangleOf(opposite)], capacity, capacity);
      edges.push_back(h);
    }
  }
  const std::vector<bool> isFront = cut.Solve();
  double ratioSum = 0.0;
  double gradientSum = 0.0;
  double total = 0.0;
  for (int h : edges)
  {
    const int a = nodeOfTriangle[TriangleMesh::TriangleOf(h)];
    const int b = nodeOfTriangle[TriangleMesh::TriangleOf(mesh.Opposite[h])];
    if (isFront[a] != isFront[b])
    {
      ghost.HalfEdges.push_back(isFront[a] ? h : mesh.Opposite[h]);
      const double length = (mesh.Points[mesh.From(h)] - mesh.Points[mesh.To(h)]).norm();
      ratioSum += length * 0.5 * (ratios[mesh.From(h)] + ratios[mesh.To(h)]);
      gradientSum += length * gradient(h);
      total += length;
    }
  }
  if (total <= 0.0)
  {
    return false;
  }
  ghost.Peak = peak;
  ghost.Ratio = ratioSum / total;
  ghost.Strength = largest > 0.0 ? gradientSum / total / largest : 0.0;
  return true;
}
}

std::vector<double> GradientProfile(const AnalyzedMesh& side, const Branch& chain, double kernel)
{
  std::vector<double> ratios;
  std::vector<double> values;
  for (std::size_t i = 0; i < chain.Nodes.size(); ++i)
  {
    const std::vector<int>& vertices = side.Skeleton.Graph[chain.Nodes[i]].Vertices;
    if (vertices.empty())
    {
      continue;
    }
    double sum = 0.0;
    for (int v : vertices)
    {
      sum += side.GradientMagnitude[v];
    }
    ratios.push_back(chain.ArcLength[i] / chain.Length());
    values.push_back(sum / vertices.size());
  }
  if (values.empty())
  {
    return {};
  }
  std::vector<double> raw(NumberOfSamples);
  std::size_t next = 0;
  for (int k = 0; k < NumberOfSamples; ++k)
  {
    const double at = static_cast<double>(k) / (NumberOfSamples - 1);
    while (next < ratios.size() && ratios[next] < at)
    {
      ++next;
    }
    if (next == 0 || next == ratios.size())
    {
      raw[k] = values[next == 0 ? 0 : next - 1];
    }
    else
    {
      const double t = (at - ratios[next - 1]) / (ratios[next] - ratios[next - 1]);
      raw[k] = (1.0 - t) * values[next - 1] + t * values[next];
    }
  }
  std::vector<double> smooth(NumberOfSamples);
  const double deviation = kernel * (NumberOfSamples - 1);
  const int reach = static_cast<int>(std::ceil(3.0 * deviation));
  for (int k = 0; k < NumberOfSamples; ++k)
  {
    double sum = 0.0;
    double total = 0.0;
    for (int j = std::max(0, k - reach); j <= std::min(NumberOfSamples - 1, k + reach); ++j)
    {
      const double weight = std::exp(-0.5 * (j - k) * (j - k) / (deviation * deviation));
      sum += weight * raw[j];
      total += weight;
    }
    smooth[k] = sum / total;
  }
  return smooth;
}

std::vector<GhostBoundary> FindGhostBoundaries(
  const AnalyzedMesh& side, const Branch& chain, double theta, double kernel)
{
  std::vector<GhostBoundary> ghosts;
  const std::vector<double> profile = GradientProfile(side, chain, kernel);
  if (profile.empty())
  {
    return ghosts;
  }
  const std::vector<double> peaks = FindPeaks(profile, theta);
  if (peaks.empty())
  {
    return ghosts;
  }
  const std::vector<double> ratios = RatioOfVertices(side, chain);
  const double largest =
    *std::max_element(side.GradientMagnitude.begin(), side.GradientMagnitude.end());
  for (double peak : peaks)
  {
    GhostBoundary ghost;
    if (CutFuzzyRegion(side, ratios, peak, 1.5 * kernel, largest, ghost))
    {
      ghosts.push_back(ghost);
    }
  }
  return ghosts;
}

std::optional<Landmark> MatchGhostBoundaries(
  const std::vector<GhostBoundary>& source, const std::vector<GhostBoundary>& target)
{
  std::optional<Landmark> best;
  // The paper takes the best pair however bad it is; but two landmarks that are more than a tenth of
  // the branch apart are more likely two different places, and would drag the boundaries along.
  constexpr double mostCost = 0.01;
  double least = mostCost;
  constexpr double tip = 0.01; // of the chain: its ends are no change of thickness
  const auto isInside = [](double ratio) { return ratio > tip && ratio < 1.0 - tip; };
  for (const GhostBoundary& s : source)
  {
    for (const GhostBoundary& t : target)
    {
      const double cost = (s.Ratio - t.Ratio) * (s.Ratio - t.Ratio) +
        (s.Strength - t.Strength) * (s.Strength - t.Strength);
      if (cost < least && isInside(s.Ratio) && isInside(t.Ratio))
      {
        least = cost;
        best = Landmark{ s.Ratio, t.Ratio };
      }
    }
  }
  return best;
}

std::vector<ChainAlignment> AlignWithLandmarks(const AnalyzedMesh& source,
  const AnalyzedMesh& target, const MatchedSkeletons& match, double theta, double kernel)
{
  std::vector<ChainAlignment> alignments;
  for (const ChainPair& chain : match.Chains)
  {
    const auto landmark =
      MatchGhostBoundaries(FindGhostBoundaries(source, chain.Source, theta, kernel),
        FindGhostBoundaries(target, chain.Target, theta, kernel));
    alignments.push_back(AlignChains(source, chain.Source, target, chain.Target, landmark));
  }
  return alignments;
}
}
