// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionShape_h
#define marrow_CollectionShape_h

#include "AnalyzedMesh.h"
#include "CoarseMesh.h"
#include "MeshSmoother.h"
#include "SourceSearch.h"

#include <memory>
#include <mutex>
#include <string>

namespace marrow
{
/// One shape of a collection, a body of one of its meshes, and what is found out about it once for all
/// of its pairs.
struct CollectionShape
{
  explicit CollectionShape(const AnalyzedMesh& fine);

  const AnalyzedMesh& Fine;
  CoarseMesh Coarse;
  /// Of the whole content, 32 hexadecimal digits: shapes of the same key are the same.
  std::string Key;

  /// What maps are made with; made when they are first asked for, on any thread, as pairs from files need none.
  std::shared_ptr<const SourceSearch> GetFineSearch() const;
  std::shared_ptr<const SourceSearch> GetCoarseSearch() const;
  std::shared_ptr<const MeshSmoother> GetCoarseSmoother() const;

private:
  mutable std::mutex Guard; ///< of all that follow
  mutable std::shared_ptr<const SourceSearch> FineSearch;
  mutable std::shared_ptr<const SourceSearch> CoarseSearch;
  mutable std::shared_ptr<const MeshSmoother> CoarseSmoother;
};
}

#endif
