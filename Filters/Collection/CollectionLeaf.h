// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionLeaf_h
#define marrow_CollectionLeaf_h

#include "CollectedMeshes.h"
#include "LabelSpread.h"
#include "RejectedAnswers.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataObjectTree;
class vtkPolyData;

namespace marrow
{
/// A leaf of the tree, and what comes of it.
struct CollectionLeaf
{
  vtkDataObject* Data = nullptr;
  vtkPolyData* Mesh = nullptr; ///< null if it is none, or cannot be used
  std::string Name;
  std::vector<int> Labels; ///< per cell; of a target those found
  bool IsSource = false;
  std::vector<double> Confidence; ///< per cell
  std::shared_ptr<const CollectedMesh> Collected;
  int Source = -1; ///< the leaf that counts most for it
  double Against = 0.0;
  double Learning = 0.0;
  double HeldOutAccuracy = std::numeric_limits<double>::quiet_NaN();
  double HeldOutAccuracyLearnt = std::numeric_limits<double>::quiet_NaN();
  double MeanConfidence = 0.0;
  bool IsWholeAlignment = false;
  std::vector<RejectedAnswer> Rejected; ///< Labels per cell
  std::string Note;

  void AddNote(const std::string& note);
};

/// A body of a leaf, as one shape of the collection.
struct ShapeOfLeaf
{
  int Leaf = 0;
  int Body = 0;
  std::shared_ptr<const CollectionShape> Shape;
  std::vector<int> Labels; ///< per triangle; empty: not known
};

/// In the order of the tree.
std::vector<CollectionLeaf> LeavesOf(vtkDataObjectTree* tree);

/// The bodies of all leaves, in an order that their contents alone give.
std::vector<ShapeOfLeaf> ShapesOf(const std::vector<CollectionLeaf>& leaves);

/// Brings what the bodies got to the cells of their leaves; `rejected` are the answers that the largest bodies
/// did not take.
void BringToCells(const std::vector<ShapeOfLeaf>& shapes, const std::vector<SpreadLabels>& spread,
  const std::vector<std::vector<RejectedAnswer>>& rejected, std::vector<CollectionLeaf>& leaves);
}

#endif
