// SPDX-License-Identifier: BSD-3-Clause
#include "LabelCut.h"

#include "MinimumCut.h"

#include <limits>

namespace marrow
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

double CostOf(const std::vector<std::pair<int, double>>& costs, int label)
{
  for (const auto& [candidate, cost] : costs)
  {
    if (candidate == label)
    {
      return cost;
    }
  }
  return Infinity;
}

/// Lets `alpha` grow once.
void Expand(const LabelProblem& problem, const std::vector<int>& sites,
  const std::vector<std::vector<int>>& edgesOfSites, int alpha, std::vector<int>& nodeOfSite,
  std::vector<int>& labels)
{
  std::vector<int> active;
  for (int site : sites)
  {
    if (labels[site] != alpha)
    {
      nodeOfSite[site] = static_cast<int>(active.size());
      active.push_back(site);
    }
  }
  MinimumCut cut(static_cast<int>(active.size()));
  for (int site : active)
  {
    const int node = nodeOfSite[site];
    // The sink's side takes alpha.
    cut.AddTerminal(
      node, CostOf(problem.Costs[site], alpha), CostOf(problem.Costs[site], labels[site]));
    for (int e : edgesOfSites[site])
    {
      const LabelProblem::Edge& edge = problem.Edges[e];
      const int other = edge.A == site ? edge.B : edge.A;
      const int otherNode = nodeOfSite[other];
      if (otherNode < 0)
      {
        cut.AddTerminal(node, labels[other] != alpha ? edge.Weight : 0.0,
          labels[other] != labels[site] ? edge.Weight : 0.0);
      }
      else if (edge.A == site)
      {
        // Kolmogorov and Zabih's graph for a pair of which neither has alpha yet.
        const double both = labels[site] != labels[other] ? edge.Weight : 0.0;
        cut.AddTerminal(node, edge.Weight - both, 0.0);
        cut.AddTerminal(otherNode, 0.0, edge.Weight);
        cut.AddEdge(node, otherNode, 2.0 * edge.Weight - both, 0.0);
      }
    }
  }
  const std::vector<bool> keeps = cut.Solve();
  for (int site : active)
  {
    if (!keeps[nodeOfSite[site]])
    {
      labels[site] = alpha;
    }
    nodeOfSite[site] = -1;
  }
}

double Energy(const LabelProblem& problem, const std::vector<int>& labels)
{
  double energy = 0.0;
  for (std::size_t s = 0; s < labels.size(); ++s)
  {
    energy += CostOf(problem.Costs[s], labels[s]);
  }
  for (const LabelProblem::Edge& edge : problem.Edges)
  {
    energy += labels[edge.A] != labels[edge.B] ? edge.Weight : 0.0;
  }
  return energy;
}
}

std::vector<int> SolveLabels(const LabelProblem& problem, const Progress& progress)
{
  const int numberOfSites = static_cast<int>(problem.Costs.size());
  std::vector<int> labels(numberOfSites, 0);
  std::vector<std::vector<int>> sitesOfLabels(problem.NumberOfLabels);
  for (int s = 0; s < numberOfSites; ++s)
  {
    double least = Infinity;
    for (const auto& [label, cost] : problem.Costs[s])
    {
      if (cost < least)
      {
        least = cost;
        labels[s] = label;
      }
      if (problem.Costs[s].size() > 1)
      {
        sitesOfLabels[label].push_back(s);
      }
    }
  }
  std::vector<std::vector<int>> edgesOfSites(numberOfSites);
  for (std::size_t e = 0; e < problem.Edges.size(); ++e)
  {
    edgesOfSites[problem.Edges[e].A].push_back(static_cast<int>(e));
    edgesOfSites[problem.Edges[e].B].push_back(static_cast<int>(e));
  }

  std::vector<int> nodeOfSite(numberOfSites, -1);
  double energy = Energy(problem, labels);
  constexpr int mostRounds = 4; // only a bound; two are the rule
  for (int round = 0; round < mostRounds; ++round)
  {
    const std::vector<int> before = labels;
    for (int alpha = 0; alpha < problem.NumberOfLabels; ++alpha)
    {
      if (!Report(
            progress, (round + static_cast<double>(alpha) / problem.NumberOfLabels) / mostRounds))
      {
        return labels;
      }
      if (!sitesOfLabels[alpha].empty())
      {
        Expand(problem, sitesOfLabels[alpha], edgesOfSites, alpha, nodeOfSite, labels);
      }
    }
    // Rounding can make equal labellings take turns; only a gain counts as one.
    const double reached = Energy(problem, labels);
    constexpr double gain = 1e-9; // less is rounding
    if (reached >= energy * (1.0 - gain))
    {
      return reached < energy ? labels : before;
    }
    energy = reached;
  }
  return labels;
}
}
