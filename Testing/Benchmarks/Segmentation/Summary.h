// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Summary_h
#define marrow_Summary_h

#include "Method.h"
#include "ReferenceFigures.h"
#include "ResultTable.h"

#include <iosfwd>

namespace marrow::bench
{
/// What came out for a category, or on the mean over the categories of a group.
struct SummaryRow
{
  std::string Name;
  bool IsGroup = false;
  std::map<std::string, double> Values; ///< by column of SummaryColumns
  std::map<std::string, double> Bars;   ///< of a group

  double Value(const std::string& column) const
  {
    const auto found = this->Values.find(column);
    return found == this->Values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }
};

/// Names of the columns:
/// - label_accuracy, rand_error: mean over the pairs; _median, _worst; means of further columns of
///   the pairs by their names;
/// - shares over all pairs or meshes: same_label_share, same_label_terminal_share,
///   consistent_share, left_right_share, front_back_share (of the pairs judged by feature points),
///   coverage, inside_share, terminal_recall, terminal_precision;
/// - spurs_per_mesh; wrong_loops (meshes whose loops differ from the genus); pairs, errors;
/// - the baselines of figures.json.
const std::vector<std::string>& SummaryColumns();

/// The categories in the order of `categories`, then the groups.
std::vector<SummaryRow> Summarize(const std::vector<std::string>& categories,
  const std::vector<Result>& pairs, const std::vector<Result>& meshes,
  const ReferenceFigures& figures);

/// Every row names the skeleton and the matcher too, so that tables can be put together.
void WriteSummary(
  const std::vector<SummaryRow>& rows, const Method& method, const std::string& path);

/// The most important columns, for a terminal.
void PrintSummary(const std::vector<SummaryRow>& rows, std::ostream& stream);
}

#endif
