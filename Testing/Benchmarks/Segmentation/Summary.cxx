// SPDX-License-Identifier: BSD-3-Clause
#include "Summary.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
/// Results of one category.
class Selection
{
public:
  Selection(const std::vector<Result>& results, const std::string& category)
  {
    std::copy_if(results.begin(), results.end(), std::back_inserter(this->Results),
      [&](const Result& result) { return result.Category == category; });
  }

  /// Measured values, ascending.
  std::vector<double> Sorted(const std::string& column) const
  {
    std::vector<double> values;
    for (const Result& result : this->Results)
    {
      if (!std::isnan(result.Value(column)))
      {
        values.push_back(result.Value(column));
      }
    }
    std::sort(values.begin(), values.end());
    return values;
  }

  double Sum(const std::string& column) const
  {
    double sum = 0.0;
    for (const double value : this->Sorted(column))
    {
      sum += value;
    }
    return sum;
  }

  /// NaN where nothing was measured, as 0/0 is.
  double Mean(const std::string& column) const
  {
    return this->Sum(column) / this->Sorted(column).size();
  }
  double Share(const std::string& part, const std::string& whole) const
  {
    return this->Sum(part) / this->Sum(whole);
  }

  double Median(const std::string& column) const
  {
    const std::vector<double> values = this->Sorted(column);
    const std::size_t size = values.size();
    return size == 0 ? std::numeric_limits<double>::quiet_NaN()
                     : 0.5 * (values[(size - 1) / 2] + values[size / 2]);
  }

  double Extreme(const std::string& column, bool largest) const
  {
    const std::vector<double> values = this->Sorted(column);
    return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : (largest ? values.back() : values.front());
  }

  std::vector<Result> Results;
};

const std::vector<std::string>& PairMeans()
{
  static const std::vector<std::string> columns = { "label_accuracy_possible", "hamming_distance",
    "missing_rate", "false_alarm_rate", "gce", "lce", "cut_discrepancy", "rand_error_to_labels",
    "boundary_distance_to_labels", "segments_missing", "correspondence_confidence",
    "segment_confidence", "seconds_correspondence", "seconds_transfer" };
  return columns;
}

SummaryRow SummarizeCategory(const std::string& category, const std::vector<Result>& allPairs,
  const std::vector<Result>& allMeshes, const ReferenceFigures& figures)
{
  const Selection pairs(allPairs, category);
  const Selection meshes(allMeshes, category);
  SummaryRow row;
  row.Name = category;
  std::map<std::string, double>& values = row.Values;
  for (const auto& [column, largestIsWorst] :
    { std::pair("label_accuracy", false), std::pair("rand_error", true) })
  {
    values[column] = pairs.Mean(column);
    values[column + std::string("_median")] = pairs.Median(column);
    values[column + std::string("_worst")] = pairs.Extreme(column, largestIsWorst);
  }
  for (const std::string& column : PairMeans())
  {
    values[column] = pairs.Mean(column);
  }
  values["same_label_share"] = pairs.Share("same_label_pairs", "matched_pairs");
  values["same_label_terminal_share"] = pairs.Share("same_label_terminals", "matched_terminals");
  values["consistent_share"] = pairs.Share("consistent_pairs", "judged_pairs");
  values["left_right_share"] = pairs.Share("left_right_flips", "judged_pairs");
  values["front_back_share"] = pairs.Share("front_back_flips", "judged_pairs");
  values["coverage"] = pairs.Share("matched_feature_nodes", "feature_nodes");
  values["inside_share"] = meshes.Share("nodes_inside", "nodes");
  values["terminal_recall"] = meshes.Share("found_extremities", "extremities");
  values["terminal_precision"] = meshes.Share("right_terminals", "judged_terminals");
  values["spurs_per_mesh"] = meshes.Mean("spurs");
  values["seconds_field"] = meshes.Mean("seconds_field");
  values["seconds_skeleton"] = meshes.Mean("seconds_skeleton");
  values["wrong_loops"] = std::count_if(meshes.Results.begin(), meshes.Results.end(),
    [](const Result& mesh) { return mesh.Value("loops") != mesh.Value("genus"); });
  values["pairs"] = pairs.Results.size();
  values["errors"] = std::count_if(pairs.Results.begin(), pairs.Results.end(),
    [](const Result& pair) { return !pair.Error.empty(); });
  for (const auto& [peer, ofCategory] : figures.Peers)
  {
    const auto found = ofCategory.find(category);
    if (found != ofCategory.end())
    {
      values[peer] = found->second;
    }
  }
  return row;
}

bool IsCount(const std::string& column)
{
  return column == "pairs" || column == "errors" || column == "wrong_loops";
}

/// Counts are added up; the rest is the mean over the categories that have it.
SummaryRow SummarizeGroup(const std::vector<SummaryRow>& categories, const CategoryGroup& group)
{
  SummaryRow row;
  row.Name = group.Name;
  row.IsGroup = true;
  row.Bars = group.Bars;
  for (const std::string& column : SummaryColumns())
  {
    double sum = 0.0;
    int count = 0;
    for (const SummaryRow& category : categories)
    {
      const bool belongs = group.Categories.empty() || group.Categories.count(category.Name) > 0;
      if (belongs && !std::isnan(category.Value(column)))
      {
        sum += category.Value(column);
        ++count;
      }
    }
    if (count > 0)
    {
      row.Values[column] = IsCount(column) ? sum : sum / count;
    }
  }
  for (const auto& [peer, value] : group.Peers)
  {
    row.Values[peer] = value;
  }
  return row;
}
}

const std::vector<std::string>& SummaryColumns()
{
  static const std::vector<std::string> columns = []
  {
    std::vector<std::string> all = { "label_accuracy", "label_accuracy_median",
      "label_accuracy_worst", "rigid_label_accuracy", "rand_error", "rand_error_median",
      "rand_error_worst", "rigid_rand_error", "humans_rand_error" };
    all.insert(all.end(), PairMeans().begin(), PairMeans().end());
    for (const char* column :
      { "same_label_share", "same_label_terminal_share", "consistent_share", "left_right_share",
        "front_back_share", "coverage", "inside_share", "terminal_recall", "terminal_precision",
        "spurs_per_mesh", "wrong_loops", "seconds_field", "seconds_skeleton", "pairs", "errors" })
    {
      all.push_back(column);
    }
    return all;
  }();
  return columns;
}

std::vector<SummaryRow> Summarize(const std::vector<std::string>& categories,
  const std::vector<Result>& pairs, const std::vector<Result>& meshes,
  const ReferenceFigures& figures)
{
  std::vector<SummaryRow> rows;
  for (const std::string& category : categories)
  {
    rows.push_back(SummarizeCategory(category, pairs, meshes, figures));
  }
  const std::vector<SummaryRow> ofCategories = rows;
  for (const CategoryGroup& group : figures.Groups)
  {
    rows.push_back(SummarizeGroup(ofCategories, group));
  }
  return rows;
}

void WriteSummary(
  const std::vector<SummaryRow>& rows, const Method& method, const std::string& path)
{
  std::ofstream file(path);
  file << "category,skeleton,matcher";
  for (const std::string& column : SummaryColumns())
  {
    file << "," << column;
  }
  file << "\n" << std::setprecision(4);
  for (const SummaryRow& row : rows)
  {
    file << row.Name << "," << method.SkeletonName() << "," << method.MatcherName();
    for (const std::string& column : SummaryColumns())
    {
      file << ",";
      if (!std::isnan(row.Value(column)))
      {
        file << row.Value(column);
      }
    }
    file << "\n";
  }
  if (!file)
  {
    throw std::runtime_error(path + ": the file cannot be written.");
  }
}

void PrintSummary(const std::vector<SummaryRow>& rows, std::ostream& stream)
{
  const std::vector<std::pair<const char*, const char*>> columns = {
    { "accuracy", "label_accuracy" }, { "median", "label_accuracy_median" },
    { "worst", "label_accuracy_worst" }, { "rigid", "rigid_label_accuracy" },
    { "Rand", "rand_error" }, { "median", "rand_error_median" }, { "worst", "rand_error_worst" },
    { "rigid", "rigid_rand_error" }, { "humans", "humans_rand_error" },
    { "nodes=", "same_label_share" }, { "tips=", "same_label_terminal_share" },
    { "coverage", "coverage" }, { "inside", "inside_share" }, { "recall", "terminal_recall" },
    { "precis.", "terminal_precision" }
  };
  constexpr int widthOfName = 17;
  constexpr int width = 9;
  stream << std::left << std::setw(widthOfName) << "" << std::right;
  for (const auto& [title, column] : columns)
  {
    stream << std::setw(width) << title;
  }
  stream << std::setw(width) << "pairs" << std::setw(width) << "errors"
         << "\n"
         << std::fixed << std::setprecision(3);
  for (const SummaryRow& row : rows)
  {
    stream << std::left << std::setw(widthOfName) << row.Name << std::right;
    for (const auto& [title, column] : columns)
    {
      if (std::isnan(row.Value(column)))
      {
        stream << std::setw(width) << "-";
      }
      else
      {
        stream << std::setw(width) << row.Value(column);
      }
    }
    stream << std::setw(width) << static_cast<int>(row.Value("pairs")) << std::setw(width)
           << static_cast<int>(row.Value("errors")) << "\n";
  }
}
}
