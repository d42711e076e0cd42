// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_HintOptions_h
#define marrow_HintOptions_h

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;

/// --hint and --forbid: pairs of points of two meshes that are of the same part, or must not be taken for
/// that.
class HintOptions
{
public:
  void Declare(CLI::App& app);

  bool IsEmpty() const { return this->Hints.empty() && this->Forbidden.empty(); }

  /// Connects the pairs to the two ports of a filter that takes hints. Throws CommandError, with the
  /// mesh's path, on a point that it has not got.
  struct Side
  {
    int Port;
    vtkPolyData* Mesh;
    std::string Path;
  };
  void Connect(vtkAlgorithm* filter, const Side& source, const Side& target) const;

private:
  std::vector<std::string> Hints; ///< SOURCE:TARGET
  std::vector<std::string> Forbidden;
};

#endif
