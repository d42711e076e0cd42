// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionShape_h
#define marrow_CollectionShape_h

#include "AnalyzedMesh.h"
#include "CoarseMesh.h"
#include "MeshSmoother.h"
#include "SourceSearch.h"

#include <memory>
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
  std::shared_ptr<const SourceSearch> FineSearch;
  std::shared_ptr<const SourceSearch> CoarseSearch;
  std::shared_ptr<const MeshSmoother> CoarseSmoother;
  /// Of the whole content, 32 hexadecimal digits: shapes of the same key are the same.
  std::string Key;
};
}

#endif
