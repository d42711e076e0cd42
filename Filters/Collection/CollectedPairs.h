// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectedPairs_h
#define marrow_CollectedPairs_h

#include "Progress.h"
#include "ShapePair.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace marrow
{
/// Matches pairs of shapes, and keeps them, in files too if there is a folder for them.
class CollectedPairs
{
public:
  using Ends = std::pair<ShapePair::Shape, ShapePair::Shape>;

  /// One for each pair of shapes. False if `progress` asked to stop; what was done until then is kept. What
  /// is not among the pairs is forgotten, but not its file.
  bool Collect(const std::vector<Ends>& ends, const std::string& folder,
    std::vector<ShapePair*>& pairs, const Progress& progress);

  /// Takes from the files what other processes have found out meanwhile.
  void ReadAgain(const std::string& folder);

  /// Writes the pairs of which more is known than when they were read or written.
  void Save(const std::string& folder);

private:
  struct Entry
  {
    std::unique_ptr<ShapePair> Pair;
    std::size_t NumberInFile = 0; ///< of carried maps
    bool IsInFile = false;
  };
  std::map<std::pair<std::string, std::string>, Entry> Known; ///< by the keys of the shapes
};
}

#endif
