// SPDX-License-Identifier: BSD-3-Clause
#include "LabelVotes.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// A rate of 1 would count without end; nobody is so good on so few faces.
constexpr double HighestRate = 0.99;
/// Rates hardly change after that.
constexpr int MostTurns = 30;
constexpr double SmallChange = 1e-4;
}

LabelVotes CountVotes(const std::vector<Labelling>& labellings)
{
  LabelVotes votes;
  std::vector<std::vector<int>> all;
  for (const Labelling& labelling : labellings)
  {
    all.push_back(labelling.Labels);
  }
  votes.Labels = DifferentLabels(all);
  const std::size_t numberOfFaces = labellings.empty() ? 0 : labellings.front().Labels.size();
  votes.Shares = LabelShares::Zero(
    static_cast<Eigen::Index>(numberOfFaces), static_cast<Eigen::Index>(votes.Labels.size()));
  for (std::size_t f = 0; f < numberOfFaces; ++f)
  {
    auto row = votes.Shares.row(static_cast<Eigen::Index>(f));
    for (const bool isConfident : { true, false })
    {
      for (const Labelling& labelling : labellings)
      {
        const auto place =
          std::lower_bound(votes.Labels.begin(), votes.Labels.end(), labelling.Labels[f]);
        row(place - votes.Labels.begin()) += static_cast<float>(labelling.Weight *
          (isConfident && !labelling.Confidence.empty() ? labelling.Confidence[f] : 1.0));
      }
      if (row.sum() > 0.0f)
      {
        break;
      }
    }
    if (row.sum() > 0.0f)
    {
      row /= row.sum();
    }
    votes.Disagreement.push_back(
      std::clamp(1.0 - static_cast<double>(row.squaredNorm()), 0.0, 1.0));
  }
  return votes;
}

std::vector<double> WeighByTrust(
  const std::vector<double>& weightOfFace, std::vector<Labelling>& labellings)
{
  std::vector<double> rates(labellings.size(), 0.0);
  std::vector<double> given;
  for (const Labelling& labelling : labellings)
  {
    given.push_back(labelling.Weight);
  }
  for (int turn = 0; turn < MostTurns; ++turn)
  {
    const LabelVotes votes = CountVotes(labellings);
    const double others = std::max<double>(static_cast<double>(votes.Labels.size()) - 1.0, 1.0);
    double change = 0.0;
    for (std::size_t k = 0; k < labellings.size(); ++k)
    {
      double right = 0.0;
      double total = 0.0;
      for (std::size_t f = 0; f < weightOfFace.size(); ++f)
      {
        const auto place =
          std::lower_bound(votes.Labels.begin(), votes.Labels.end(), labellings[k].Labels[f]);
        right += weightOfFace[f] *
          votes.Shares(static_cast<Eigen::Index>(f), place - votes.Labels.begin());
        total += weightOfFace[f];
      }
      const double rate = std::min(total > 0.0 ? right / total : 0.0, HighestRate);
      change = std::max(change, std::abs(rate - rates[k]));
      rates[k] = rate;
    }
    bool isAny = false;
    for (std::size_t k = 0; k < labellings.size(); ++k)
    {
      labellings[k].Weight =
        given[k] * std::max(std::log(rates[k] * others / (1.0 - rates[k])), 0.0);
      isAny = isAny || labellings[k].Weight > 0.0;
    }
    // Nobody is better than chance.
    for (std::size_t k = 0; k < labellings.size() && !isAny; ++k)
    {
      labellings[k].Weight = given[k];
    }
    if (change < SmallChange || !isAny)
    {
      break;
    }
  }
  return rates;
}
}
