// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionSummary_h
#define marrow_CollectionSummary_h

#include "CollectionFolder.h"

#include <limits>
#include <map>
#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;

/// What a collection's summary says of one mesh.
struct CollectionRow
{
  std::string Name;
  std::string File;
  std::string Role;   ///< "source", "target" or "failed"
  std::string Source; ///< the labelled mesh that counts most for it
  double Confidence = 0.0;
  double Against = 0.0;
  double Learning = 0.0; ///< the power of what was learnt; 0: nothing
  /// Of a labelled mesh whose labels were held back, by the vote alone and with what was learnt.
  double HeldOutAccuracy = std::numeric_limits<double>::quiet_NaN();
  double HeldOutAccuracyLearnt = std::numeric_limits<double>::quiet_NaN();
  std::map<int, double> AreaOfLabel; ///< of the whole
  std::string Note;
};

/// `table` is vtkCollectionTransfer's, with a row for each entry that was read; `meshes` its meshes, null
/// for what was not used.
std::vector<CollectionRow> Summarize(const std::vector<CollectionEntry>& entries, vtkTable* table,
  const std::vector<vtkPolyData*>& meshes);

/// The least sure targets first, sources and failed ones last.
std::vector<CollectionRow> LeastSureFirst(std::vector<CollectionRow> rows);

std::string ToCsv(const std::vector<CollectionRow>& rows);
std::string ToJson(const std::vector<CollectionRow>& rows);

#endif
