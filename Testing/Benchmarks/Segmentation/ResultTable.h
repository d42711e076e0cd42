// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ResultTable_h
#define marrow_ResultTable_h

#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace marrow::bench
{
/// One measured pair, or one measured mesh (then the target is the source).
struct Result
{
  std::string Category;
  int Source = 0;
  int Target = 0;
  std::map<std::string, double> Values; ///< by column
  std::string Error;                    ///< empty if all went well

  /// NaN where it was not measured.
  double Value(const std::string& column) const
  {
    const auto found = this->Values.find(column);
    return found == this->Values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }
};

/// Results in a CSV file that grows row by row, so that an interrupted run goes on where it stopped.
class ResultTable
{
public:
  using Key = std::tuple<std::string, int, int>;

  explicit ResultTable(std::vector<std::string> columns)
    : Columns(std::move(columns))
  {
  }

  /// Adds the rows of a file, if it exists; a last row that was cut off is left out. Throws
  /// std::runtime_error if the file has other columns.
  void Read(const std::string& path);

  /// New rows go to the end of this file too.
  void AppendTo(const std::string& path);

  void Add(const Result& result);

  /// Writes all rows, sorted, to a file.
  void Write(const std::string& path) const;

  bool Has(const Key& key) const { return this->Rows.count(key) > 0; }
  std::vector<Result> Results() const;

private:
  std::string Header() const;
  std::string Line(const Result& result) const;

  std::vector<std::string> Columns;
  std::map<Key, Result> Rows;
  std::ofstream File;
};
}

#endif
