// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BenchmarkRun_h
#define marrow_BenchmarkRun_h

#include "BenchmarkData.h"
#include "Method.h"
#include "PairMeasures.h"
#include "ReferenceFigures.h"
#include "ResultTable.h"

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace marrow::bench
{
class ProgressBar;
class Ranks;

/// What the command line asks for.
struct BenchmarkOptions
{
  std::string DataFolder;
  std::string ResultFolder;
  std::vector<std::string> Categories; ///< empty: all
  int MeshesPerCategory = 0;           ///< 0: all
  int Jobs = 1;
  marrow::bench::Method Method;
  bool Quiet = false;
};

/// Measures all pairs that the result folder does not have yet.
///
/// Every rank appends to tables of its own, so that nothing is lost when one is stopped; the tables
/// of all ranks are read at the start, and the first rank joins them at the end.
class BenchmarkRun
{
public:
  /// Throws std::runtime_error.
  BenchmarkRun(const BenchmarkOptions& options, const ReferenceFigures& figures, Ranks& processes);

  /// Throws std::runtime_error.
  void Measure();

  /// After Measure, on the first rank: everything in the tables, that of earlier runs too.
  std::vector<Result> Pairs() const { return this->PairTable.Results(); }
  std::vector<Result> Meshes() const { return this->MeshTable.Results(); }

  /// Where the target's segments of a pair are kept.
  static std::string SegmentFile(const std::string& resultFolder, const Result& pair);

private:
  void CheckMethod() const;
  void ReadTables();
  void JoinTables();
  PreparedCategory Prepare(const Category& category);
  void MeasureMeshes(const Category& category, const PreparedCategory& prepared,
    const std::vector<int>& meshes, ProgressBar& bar);
  void MeasurePairs(const Category& category, const PreparedCategory& prepared,
    const std::vector<std::pair<int, int>>& pairs, ProgressBar& bar);
  /// The ordered pairs (indices of meshes) of which no rank has a result.
  std::vector<std::pair<int, int>> MissingPairs(const Category& category) const;
  /// The meshes (indices) of which no rank has a result.
  std::vector<int> MissingMeshes(const Category& category) const;
  /// Every rank takes every n-th.
  template <typename Item>
  std::vector<Item> OwnShare(const std::vector<Item>& items) const;
  std::string TableFile(const std::string& name, int rank) const;

  BenchmarkOptions Options;
  const ReferenceFigures& Figures;
  Ranks& Processes;
  std::vector<Category> Categories;
  ResultTable PairTable;
  ResultTable MeshTable;
  std::mutex Lock;
};
}

#endif
