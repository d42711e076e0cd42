// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionReport_h
#define marrow_CollectionReport_h

#include "CollectionSummary.h"

#include <map>
#include <string>
#include <vector>

class vtkPolyData;

/// So many of the answers that a mesh did not take are shown (vtkCollectionTransfer's RejectedSegmentId).
inline constexpr int MostRejectedAnswers = 3;

/// A page to look through: each mesh that was labelled in its segments and in its confidence, beside the
/// labelled mesh that it trusted most and, smaller, the answers that it did not take; the least sure first.
/// Self-contained: the pictures are in it. Needs a display.
std::string CollectionReport(
  const std::vector<CollectionRow>& rows, const std::map<std::string, vtkPolyData*>& meshOfName);

#endif
