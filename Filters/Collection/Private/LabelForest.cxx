// SPDX-License-Identifier: BSD-3-Clause
#include "LabelForest.h"

#include "ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// For each label; more take longer and hardly tell better.
constexpr int NumberOfTrees = 20;
/// Of the features each node of a tree chooses from: the root of their number is usual.
constexpr double FeaturesOfNode = 0.15;

using Sample = dlib::random_forest_regression_function<>::sample_type;

Sample SampleOf(const Eigen::MatrixXf& features, Eigen::Index row)
{
  Sample sample(features.cols());
  for (Eigen::Index c = 0; c < features.cols(); ++c)
  {
    sample(c) = features(row, c);
  }
  return sample;
}
}

LabelForest::LabelForest(
  const Eigen::MatrixXf& features, const std::vector<int>& columns, int numberOfLabels)
  : OfLabels(numberOfLabels)
{
  std::vector<Sample> samples;
  for (Eigen::Index row = 0; row < features.rows(); ++row)
  {
    samples.push_back(SampleOf(features, row));
  }
  dlib::random_forest_regression_trainer<dlib::dense_feature_extractor> trainer;
  trainer.set_num_trees(NumberOfTrees);
  trainer.set_feature_subsampling_fraction(FeaturesOfNode);
  trainer.set_seed("Marrow");
  for (int label = 0; label < numberOfLabels; ++label)
  {
    std::vector<double> isLabel;
    for (const int column : columns)
    {
      isLabel.push_back(column == label ? 1.0 : 0.0);
    }
    if (std::count(columns.begin(), columns.end(), label) > 0)
    {
      this->OfLabels[label] = trainer.train(samples, isLabel);
    }
  }
}

LabelShares LabelForest::Predict(const Eigen::MatrixXf& features) const
{
  LabelShares shares =
    LabelShares::Zero(features.rows(), static_cast<Eigen::Index>(this->OfLabels.size()));
  ParallelFor(0, static_cast<int>(features.rows()),
    [&](int first, int last)
    {
      for (int row = first; row < last; ++row)
      {
        const Sample sample = SampleOf(features, row);
        for (std::size_t label = 0; label < this->OfLabels.size(); ++label)
        {
          if (this->OfLabels[label])
          {
            shares(row, static_cast<Eigen::Index>(label)) =
              static_cast<float>((*this->OfLabels[label])(sample));
          }
        }
      }
    });
  SharpenShares(shares, 1.0);
  return shares;
}
}
