// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelForest_h
#define marrow_LabelForest_h

#include "LabelShares.h"

#include <dlib/random_forest.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace marrow
{
/// How likely each label is by the features alone: for each label a forest of regression trees (dlib's)
/// between it and all others. The same on any number of threads.
class LabelForest
{
public:
  /// `features` has a row for each of `columns`, the column of the shares that is its label.
  LabelForest(const Eigen::MatrixXf& features, const std::vector<int>& columns, int numberOfLabels);

  /// A row for each of `features`; a label that was never seen has none.
  LabelShares Predict(const Eigen::MatrixXf& features) const;

private:
  /// Per label; none for one that was never seen.
  std::vector<std::optional<dlib::random_forest_regression_function<>>> OfLabels;
};
}

#endif
