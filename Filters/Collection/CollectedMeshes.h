// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectedMeshes_h
#define marrow_CollectedMeshes_h

#include "AnalyzedSide.h"
#include "CollectionShape.h"
#include "Progress.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace marrow
{
/// All that is found out about one mesh of a collection by itself.
struct CollectedMesh
{
  AnalyzedSide Side;
  std::vector<std::unique_ptr<CollectionShape>> Shapes; ///< per body
  std::string Error; ///< why it cannot be used: one sentence, or empty
};

/// Makes meshes ready, and keeps them as long as the meshes are the same.
class CollectedMeshes
{
public:
  /// One for each mesh, those of equal content shared. False if `progress` asked to stop. What is not among
  /// the meshes is forgotten.
  bool Collect(const std::vector<vtkPolyData*>& meshes,
    std::vector<std::shared_ptr<const CollectedMesh>>& collected, const Progress& progress);

private:
  std::map<std::string, std::shared_ptr<const CollectedMesh>> Known; ///< by the content
};
}

#endif
