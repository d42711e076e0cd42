// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ReferenceFigures_h
#define marrow_ReferenceFigures_h

#include "SkeletonMeasures.h"

#include <map>
#include <string>
#include <vector>

namespace marrow::bench
{
/// Categories that are averaged together, and what the average is held against.
struct CategoryGroup
{
  std::string Name;
  std::set<std::string> Categories; ///< empty: all
  std::map<std::string, double> Bars;
  std::map<std::string, double> Peers; ///< humans_rand_error, rigid_rand_error, ...
};

/// figures.json: nothing but figures and names of labels.
struct ReferenceFigures
{
  /// Kind (humans_rand_error, rigid_rand_error, rigid_label_accuracy), then category.
  std::map<std::string, std::map<std::string, double>> Peers;
  std::vector<CategoryGroup> Groups;
  std::map<std::string, Extremities> ExtremitiesOf;
};

/// Throws std::runtime_error.
ReferenceFigures ReadReferenceFigures(const std::string& path);
}

#endif
