// SPDX-License-Identifier: BSD-3-Clause
#include "AverageGeodesicDistance.h"

#include "GeodesicSolver.h"
#include "ParallelFor.h"
#include "SharedProgress.h"
#include "VertexGraph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace marrow
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
// Enough to keep the threads busy, few enough for their sums to be kept at the same time.
constexpr int BatchesPerLoop = 8;
// On a ball, where all distances are alike, the error of the method alone spreads that far.
constexpr double RelativeSpread = 0.02;

/// Vertices that stand for others, and the area each stands for.
struct Samples
{
  std::vector<int> Ranks;
  std::vector<double> Areas;
};

/// Farthest-point samples of a component by the length of edge paths. Every Dijkstra stops where an
/// earlier sample is nearer, so all of them together cost little more than a few.
Samples FarthestPointSamples(const TriangleMesh& mesh, const std::vector<int>& order, int begin,
  int end, const std::vector<double>& vertexAreas, int numberOfSamples)
{
  std::vector<int> rankOfVertex(mesh.Points.size(), -1);
  double area = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (int rank = begin; rank < end; ++rank)
  {
    const int v = order[rank];
    rankOfVertex[v] = rank;
    area += vertexAreas[v];
    centroid += vertexAreas[v] * mesh.Points[v];
  }
  if (area > 0.0)
  {
    centroid /= area;
  }
  int next = begin;
  for (int rank = begin; rank < end; ++rank)
  {
    if ((mesh.Points[order[rank]] - centroid).squaredNorm() >
      (mesh.Points[order[next]] - centroid).squaredNorm())
    {
      next = rank;
    }
  }

  const VertexGraph graph(mesh);
  Samples samples;
  std::vector<double> distance(end - begin, Infinity);
  std::vector<int> cell(end - begin, 0);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  while (static_cast<int>(samples.Ranks.size()) < numberOfSamples)
  {
    const int sample = static_cast<int>(samples.Ranks.size());
    samples.Ranks.push_back(next);
    distance[next - begin] = 0.0;
    cell[next - begin] = sample;
    queue.push({ 0.0, next });
    while (!queue.empty())
    {
      const Entry entry = queue.top();
      queue.pop();
      const int rank = entry.second;
      if (entry.first > distance[rank - begin])
      {
        continue;
      }
      const int v = order[rank];
      graph.ForEachEdge(v,
        [&](int n, double length)
        {
          const int other = rankOfVertex[n];
          const double offer = entry.first + length;
          if (offer < distance[other - begin])
          {
            distance[other - begin] = offer;
            cell[other - begin] = sample;
            queue.push({ offer, other });
          }
        });
    }
    next = begin +
      static_cast<int>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  samples.Areas.assign(samples.Ranks.size(), 0.0);
  for (int rank = begin; rank < end; ++rank)
  {
    samples.Areas[cell[rank - begin]] += vertexAreas[order[rank]];
  }
  return samples;
}

/// Sources of one sweep should lie close together: they are taken in the solver's order.
std::vector<std::vector<int>> Batches(const std::vector<int>& sources)
{
  std::vector<std::vector<int>> batches;
  for (std::size_t first = 0; first < sources.size(); first += GeodesicSolver::Lanes)
  {
    const std::size_t last = std::min(first + GeodesicSolver::Lanes, sources.size());
    batches.emplace_back(sources.begin() + first, sources.begin() + last);
  }
  return batches;
}

/// Sum over the sources of area × distance, for every vertex of the component.
bool SumOverSources(const GeodesicSolver& solver, int component, const Samples& samples,
  std::vector<double>& sums, const Progress& progress)
{
  const int size = static_cast<int>(sums.size());
  std::vector<int> index(samples.Ranks.size());
  std::iota(index.begin(), index.end(), 0);
  std::sort(
    index.begin(), index.end(), [&](int a, int b) { return samples.Ranks[a] < samples.Ranks[b]; });
  std::vector<int> sorted;
  for (int i : index)
  {
    sorted.push_back(samples.Ranks[i]);
  }
  const auto batches = Batches(sorted);
  const int numberOfBatches = static_cast<int>(batches.size());
  // Every batch has its own sum, and they are added in order: the same bits on any number of
  // threads.
  std::vector<std::vector<double>> partial(std::min(numberOfBatches, BatchesPerLoop));
  SharedProgress shared(progress);
  for (int first = 0; first < numberOfBatches; first += BatchesPerLoop)
  {
    const int last = std::min(first + BatchesPerLoop, numberOfBatches);
    ParallelFor(first, last,
      [&](int from, int to)
      {
        std::vector<float> distances;
        for (int batch = from; batch < to; ++batch)
        {
          double done = 0.0;
          const auto addUpTo = [&](double fraction)
          {
            const double share = (fraction - done) / numberOfBatches;
            done = fraction;
            return shared.Add(share);
          };
          if (!solver.Distances(component, batches[batch], distances, addUpTo) || !addUpTo(1.0))
          {
            return;
          }
          std::vector<double> areas;
          for (std::size_t lane = 0; lane < batches[batch].size(); ++lane)
          {
            areas.push_back(samples.Areas[index[GeodesicSolver::Lanes * batch + lane]]);
          }
          std::vector<double>& sum = partial[batch - first];
          sum.resize(size);
          for (int i = 0; i < size; ++i)
          {
            const float* own =
              distances.data() + static_cast<std::size_t>(GeodesicSolver::Lanes) * i;
            sum[i] = std::inner_product(areas.begin(), areas.end(), own, 0.0);
          }
        }
      });
    if (!shared.Add(0.0))
    {
      return false;
    }
    for (int batch = first; batch < last; ++batch)
    {
      for (int i = 0; i < size; ++i)
      {
        sums[i] += partial[batch - first][i];
      }
    }
  }
  return true;
}

/// To [0,1]; all 0 where there is no spread.
void Normalize(std::vector<double>& values)
{
  const auto range = std::minmax_element(values.begin(), values.end());
  const double low = *range.first;
  const double spread = *range.second - low;
  const bool flat = !(spread > RelativeSpread * *range.second);
  for (double& value : values)
  {
    value = flat ? 0.0 : (value - low) / spread;
  }
}
}

bool ComputeAverageGeodesicDistance(const TriangleMesh& mesh, int numberOfSources,
  std::vector<double>& values, const Progress& progress)
{
  values.assign(mesh.Points.size(), 0.0);
  const GeodesicSolver solver(mesh);
  const std::vector<int>& order = solver.Order();
  const std::vector<int>& componentBegin = solver.ComponentBegin();
  const std::vector<double> vertexAreas = mesh.VertexAreas();
  const double total = static_cast<double>(order.size());

  for (std::size_t component = 0; component + 1 < componentBegin.size(); ++component)
  {
    const int begin = componentBegin[component];
    const int end = componentBegin[component + 1];
    Samples samples;
    if (numberOfSources > 0 && numberOfSources < end - begin)
    {
      samples = FarthestPointSamples(mesh, order, begin, end, vertexAreas, numberOfSources);
    }
    else
    {
      for (int rank = begin; rank < end; ++rank)
      {
        samples.Ranks.push_back(rank);
        samples.Areas.push_back(vertexAreas[order[rank]]);
      }
    }
    std::vector<double> sums(end - begin, 0.0);
    if (!SumOverSources(solver, static_cast<int>(component), samples, sums,
          SubProgress(progress, begin / total, end / total)))
    {
      return false;
    }
    Normalize(sums);
    for (int rank = begin; rank < end; ++rank)
    {
      values[order[rank]] = sums[rank - begin];
    }
  }
  return Report(progress, 1.0);
}
}
